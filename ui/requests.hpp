#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/date.hpp"
#include "core/geodesy/georeference.hpp"
#include "core/project/project_state.hpp"
#include "core/survey/fusion_choices.hpp"
#include "core/survey/rule_pack.hpp"
#include "ui/actions/action.hpp"
#include "ui/charts.hpp"
#include "ui/geometry.hpp"
#include "ui/import_view.hpp"

namespace stemwise::ui {

enum class Answer { no, yes, other };
enum class RecoveryAnswer { bring_back, throw_away, not_now };

/// What the panels ask for; `app` answers with commands, jobs and changes of the view.
namespace request {
struct Run { ActionId action; };
/// Its key was pressed while it was not possible.
struct Explain { ActionId action; std::string why_not; };
/// `stem`: the one of its stems that is meant; none: the one that its doubt is about.
struct SelectTree { TreeId tree; bool fly = true; StemRef stem = {}; };
/// `ask`: show how they are understood first, also when nothing is in doubt.
struct AddInventories { std::vector<std::string> paths; bool ask = false; };
/// Of the files in the import dialog: read one again with these settings.
struct ImportEdit { std::size_t file; ImportSettings settings; };
struct ImportFinish { bool take; };  ///< into the project, or never mind
struct AddUnderlays { std::vector<std::string> paths; };
struct RemoveUnderlay { int id; };
struct OpenProject { std::string path; };
struct SaveProject { std::string path; };
struct SetDate { InventoryId inventory; std::optional<Date> date; };
struct AcceptProbable { InventoryId inventory; };
struct SelectGroup { std::vector<TreeId> trees; };  ///< empty: none
struct LinkStems { StemRef a, b; };
struct RejectPair { StemRef a, b; };
struct AcceptPair { StemRef a, b; };
struct SetFate { TreeId tree; std::optional<Fate> fate; };
struct SetNote { TreeId tree; std::string note; };
struct SetFusion { FusionPolicy policy; };
/// The merged tree takes this value from that survey; none: by the policy again.
struct ChooseSource { TreeId tree; FusedAttribute attribute; std::optional<InventoryId> source; };
struct ChooseRules { std::optional<RulePack> pack; };
struct ReadRules { std::string path; };  ///< a person's own, from a file
struct SetGeoreference { Georeference georeference; };
struct SetDbhError { InventoryId inventory; std::optional<double> error_m; };
struct EstimateCoverage { InventoryId inventory; };  ///< instead of the drawn one

struct SetSetting { std::string key, value; };
struct GoToHistory { std::size_t position; };
struct CancelJob { int job; };
struct DismissNotice { int notice; };
struct DismissNotices {};
struct NoticeChoice { int notice; std::size_t choice; };  ///< one of the notice's buttons
struct AnswerQuestion { Answer answer; };
struct Recover { RecoveryAnswer answer; };
struct Leave { bool save; };
/// A rough position of an inventory's origin in the reference: the way out of a refusal.
struct RoughPose { InventoryId inventory; double x_m, y_m, yaw_deg, radius_m; };
/// The pairs in the view state are taken for the same trees, and everything is aligned.
struct AlignByPairs {};
/// The shape that is being drawn: closed, or without its last corner.
struct Shape { bool close; };
struct Export { std::string path, layer; int epsg = 0; bool decimal_comma = false; bool semicolon = false; };
struct WriteReport { std::string path; double area_ha = 0.0; };
struct WriteFieldCheck { std::string path; int most = 100; };
struct SaveChart { Chart chart; std::string path; };
/// A panel shows this chart at this size; the mouse is over it at x, y (negative: it is not).
struct ShowChart {
  Chart chart;
  int width_px, height_px;
  double x_px = -1.0, y_px = -1.0;
  bool clicked = false;
  double from_x_px = -1.0, from_y_px = -1.0;  ///< where a drag began that ended just now: what lies in the rectangle is selected
  bool adds = false;                          ///< to what is selected (Ctrl)
};
/// The mouse over the map or the 3D view, in pixels of the picture from its upper left corner.
struct Pointer {
  double x_px = 0, y_px = 0;
  double dx_px = 0, dy_px = 0;   ///< since the last frame, while a button is down
  double wheel = 0;
  bool hovered = false;
  bool clicked = false;          ///< pressed and released without moving
  bool double_clicked = false;
  bool left_down = false, middle_down = false, right_down = false;
  bool shift = false, ctrl = false;
};
}  // namespace request

using Request =
    std::variant<request::Run, request::Explain, request::SelectTree, request::AddInventories, request::ImportEdit, request::ImportFinish, request::AddUnderlays, request::RemoveUnderlay, request::OpenProject, request::SaveProject,
                 request::SetDate, request::AcceptProbable, request::SelectGroup, request::LinkStems,
                 request::RejectPair, request::AcceptPair, request::SetFate, request::SetNote, request::SetFusion,
                 request::ChooseSource, request::ChooseRules, request::ReadRules, request::SetGeoreference, request::SetDbhError, request::EstimateCoverage, request::SetSetting, request::GoToHistory, request::CancelJob, request::DismissNotice,
                 request::DismissNotices, request::NoticeChoice, request::AnswerQuestion, request::Recover, request::Leave, request::RoughPose, request::AlignByPairs, request::Shape, request::Export, request::WriteReport, request::WriteFieldCheck, request::SaveChart,
                 request::ShowChart, request::Pointer>;

/// Filled while a frame is drawn, emptied by `app` after it.
class Requests {
 public:
  void emit(Request request) { queue_.push_back(std::move(request)); }
  void run(ActionId action) { emit(request::Run{action}); }
  std::vector<Request> take() { return std::exchange(queue_, {}); }

 private:
  std::vector<Request> queue_;
};

}  // namespace stemwise::ui
