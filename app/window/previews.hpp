#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "app/window/gl_texture.hpp"
#include "core/survey/rule_pack.hpp"
#include "io/report/recorded_pages.hpp"
#include "ui/previews.hpp"

namespace stemwise {

struct WindowModel;

/// Works out what the forms of steps 4 and 5 would do, beside the window: one after the other, each again when the project or
/// its form has changed. The answers go into the window's status; nothing is applied. Its end needs the GL context.
class Previews {
 public:
  /// Every frame: starts what is out of date in the step that is shown.
  void tend(WindowModel& model);
  void forget();  ///< another project

  /// The page that is looked at, for drawing only what has changed.
  std::pair<std::uint64_t, std::uint64_t> page_texture() const { return {page_.id(), pages_shown_}; }

  std::optional<RulePack> own_rules;  ///< read from a person's file

 private:
  bool start_fusion(WindowModel& model);
  bool start_placement(WindowModel& model);
  bool start_rules(WindowModel& model);
  bool start_export(WindowModel& model);
  bool start_report(WindowModel& model);
  bool start_page(WindowModel& model);
  void show_page(WindowModel& model, const ui::PageForm& form, std::uint64_t revision, const PagePicture& picture);

  /// What was asked for last: a job that fails is not started again and again.
  struct Asked {
    std::uint64_t fusion = 0, rules = 0;
    std::string own_rules;
    std::pair<std::uint64_t, ui::PlacementForm> placement;
    std::pair<std::uint64_t, ui::ExportForm> exporting;
    std::pair<std::uint64_t, double> report;
    std::pair<std::uint64_t, ui::PageForm> page;
  };
  Asked asked_;
  std::shared_ptr<const RecordedPages> pages_;  ///< of `asked_.page`, whichever page of it is looked at
  GlTexture page_;
  std::uint64_t pages_shown_ = 0;
};

/// Whether the form says enough to work anything out.
bool is_complete(const ui::PlacementForm& form);
ui::PlacementPreview preview_placement(const ui::PlacementForm& form, const ProjectState& state);
ui::ExportPreview preview_export(const ui::ExportForm& form, const ProjectState& state, const Tables& tables);
RecordedPages preview_pages(const ui::PageForm& form, const ProjectState& state, const Tables& tables);
ui::ReportPreview preview_report(double area_ha, const ProjectState& state, const Tables& tables);

}  // namespace stemwise
