#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/issue.hpp"
#include "ui/charts.hpp"
#include "ui/geometry.hpp"
#include "ui/import_view.hpp"
#include "ui/previews.hpp"

namespace stemwise::ui {

/// One job as shown.
struct JobView {
  enum class State { waiting, running, done, failed, cancelled };
  int id = 0;
  std::string title;      ///< "Align 3 surveys"
  std::string stage;      ///< "Verifying poses"
  double fraction = 0.0;  ///< 0..1
  double elapsed_s = 0.0;
  std::optional<double> left_s;
  State state = State::waiting;
  std::string outcome;    ///< one sentence when it is over
};

struct Notice {
  int id = 0;
  Severity severity = Severity::note;
  std::string title;
  Issues details;
  double age_s = 0.0;
  std::vector<std::string> choices;  ///< buttons: what can be done about it at once
};

/// Something to decide before the work goes on.
struct Question {
  std::string title;  ///< "Replace trees.csv?"
  std::string text;
  std::string yes;    ///< "Replace": what is done
  std::string no;     ///< "Keep the old one"
  std::string other;  ///< a way that loses nothing, where there is one: "Save as a copy"
};

/// The rendered map or 3D view, as a GL texture whose first row is at the bottom.
struct ViewportPicture {
  std::uint64_t texture = 0;
  int width_px = 0;
  int height_px = 0;
  std::uint64_t later_texture = 0;  ///< while two surveys are compared: the same view of the later one; else 0
  std::string earlier, later;       ///< what they are called
};

/// A line over the picture, in its pixels.
struct OverlayLine {
  double x0_px = 0.0, y0_px = 0.0, x1_px = 0.0, y1_px = 0.0;
};

/// A place with words beside it, in the picture's pixels: a control point with its residual.
struct OverlayMark {
  double x_px = 0.0, y_px = 0.0;
  std::string words;
  bool warning = false;
};

/// Words for what the mouse is over in the viewport.
struct HoverCard {
  double x_px = 0.0, y_px = 0.0;  ///< of the stem, in the picture
  std::string title;              ///< "T-01482 · 31.4 to 32.6 cm"
  std::string detail;
  bool warning = false;
};

/// One entry of a colour legend.
struct LegendEntry {
  Color color;
  std::string label;
};

/// What `app` knows beside the project, ready to be shown. Values only.
struct WindowStatus {
  std::string project_title;
  std::string saved_text;                   ///< "saved 12 s ago", "not saved yet", ...
  std::vector<std::string> recent_projects;
  std::vector<JobView> jobs;                ///< newest first
  std::vector<Notice> notices;              ///< newest first
  ViewportPicture viewport;
  ChartViews charts;                        ///< those that were asked for
  std::optional<HoverCard> hover;           ///< of the stem under the mouse, else of the selected one
  std::string cursor_local, cursor_projected, cursor_geographic;
  std::vector<LegendEntry> legend;
  std::string legend_caption;               ///< "DBH, cm"
  double most_zoom_percent = 200.0;         ///< at which everything has room in the window
  std::string home_folder, working_folder;
  std::string project_folder;               ///< where what is written belongs: the project's, else its first survey's
  std::vector<std::string> places;          ///< folders used lately
  std::string version;
  std::string renderer;                     ///< GL_RENDERER
  std::optional<OverlayLine> click_line;    ///< from the stem that a tool began with to the one under the mouse
  std::optional<Rect> selection_box;        ///< drawn by the mouse just now, in the picture's pixels
  std::optional<OverlayLine> measure_line;
  std::string measure_text;                 ///< what the measuring tool has to say
  std::vector<OverlayLine> shape;           ///< sides of the lasso or coverage that is being drawn; the last one goes back to its start
  std::vector<OverlayMark> control_marks;   ///< of the placement that is worked out, in step 4
  std::vector<OverlayLine> pair_lines;      ///< between stems said to be the same tree
  std::optional<PlacementPreview> placement;
  bool placement_busy = false;              ///< another form is being worked out
  std::optional<FusionPreview> fusion;
  std::optional<RulePreviews> rules;
  std::optional<ExportPreview> exporting;
  std::optional<ReportPreview> reporting;
  std::optional<PageView> page;             ///< of the dialog `pages`; may be of another form for a moment
  std::string recovery_text;                ///< what autosave has left behind, empty when nothing
  std::vector<ImportFile> imports;          ///< what the import dialog is about
  std::optional<Question> question;         ///< asked while the dialog `question` is open

  const JobView* running() const {
    for (const JobView& job : jobs) {
      if (job.state == JobView::State::running) return &job;
    }
    return nullptr;
  }
};

}  // namespace stemwise::ui
