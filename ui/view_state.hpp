#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/ids.hpp"
#include "core/survey/fate.hpp"
#include "ui/charts.hpp"
#include "ui/previews.hpp"
#include "ui/queue_filter.hpp"
#include "ui/theme/style.hpp"

namespace stemwise::ui {

enum class Step { inventories = 1, align, review, merge, report };
enum class ViewMode { map, space };
/// `lasso` and `coverage` take corners by clicks; `pair` two stems of surveys that are not aligned yet.
enum class Tool { select, rectangle, lasso, measure, link, swap, merge, pair, coverage };
enum class Heat { none, density, times_seen, residual };
enum class ColorBy { inventory, fate, dbh, growth, residual, confidence, times_seen };
enum class BottomTab { queue, matches, growth, conflicts, log, jobs };
enum class Dialog { none, open_project, add_inventories, import_inventories, import, add_underlay, save_project, export_path, report_path, field_check_path, chart_path, control_file, gnss_file, rules_file, palette, keys, about, history, recover, leave, question, pages };

/// What is laid over the map and the 3D view.
struct Layers {
  bool links = true;
  bool coverage = true;
  bool grid = true;
  bool ground = true;
  bool labels = false;
  bool underlays = true;
  bool residuals = false;  ///< arrows from sighting to sighting, lengthened
  bool operator==(const Layers&) const = default;
};

enum class CloudShade { colour, intensity, height };

/// An image or a point cloud under the stems: how the person wants it, and what `app` has to say about it.
struct Underlay {
  enum class State { wanted, reading, shown, failed };
  int id = 0;
  std::string path;
  bool is_cloud = false;
  InventoryId frame;               ///< whose coordinates it has where it names no system
  bool is_local = false;           ///< it names none
  bool visible = true;
  float opacity = 0.8f;
  float low_m = lowest_m, high_m = highest_m;  ///< cloud: only points between these heights above the ground; the ends mean no limit
  CloudShade shade = CloudShade::height;
  bool has_colour = false, has_intensity = false;
  bool is_remembered = false;      ///< of the last time: stays in the list also when it cannot be read
  State state = State::wanted;
  std::string about;               ///< what it is, or why it is not there
  static constexpr float lowest_m = -2.0f, highest_m = 40.0f;
};

/// Of step 5.
enum class ReportSection { none, export_layer, rules, report, field_check };

/// Sizes of the panels at 100 %, and which are folded away.
struct PanelSizes {
  float left = 272.0f;
  float right = 360.0f;
  float bottom = 310.0f;
  bool show_left = true;
  bool show_right = true;
  bool show_bottom = true;
  bool operator==(const PanelSizes&) const = default;
};

/// What the person looks at and how: the window's own state. Not part of the project, no undo.
struct ViewState {
  Step step = Step::inventories;
  ViewMode mode = ViewMode::map;
  Tool tool = Tool::select;
  ColorBy color_by = ColorBy::fate;
  BottomTab tab = BottomTab::queue;
  Layers layers;
  std::vector<Underlay> underlays;  ///< lowest first
  std::set<InventoryId> hidden;
  std::optional<Fate> only_fate;   ///< the map and the tables show only these
  TreeId selected_tree;
  StemRef selected_stem;           ///< of the selected tree: Unlink takes it out, Accept and Reject decide on its match
  InventoryId selected_inventory;
  std::vector<TreeId> group;       ///< several trees selected together, ascending; decisions mean all of them
  StemRef link_from;               ///< while the tools link, swap and merge wait for the second stem
  std::vector<std::pair<StemRef, StemRef>> pairs;  ///< said to be the same trees, for surveys that could not be aligned; the reference's stem first
  bool ghost = false;              ///< the selected survey is shown a second time at its second-best pose
  QueueFilter queue;
  Heat heat = Heat::none;
  bool blink = false;
  bool slide = false;              ///< the last two surveys side by side, with a bar to drag between them
  bool before_after = false;       ///< the selected survey as it was given, and aligned, side by side with the same bar
  float slide_at = 0.5f;           ///< of the picture's width: left of it the earlier survey, right of it the later one
  ThemeName theme = ThemeName::light;
  bool reduce_motion = false;
  bool goes_on = false;            ///< a decision on a tree in doubt leads to the next one
  double zoom_percent = 100.0;     ///< of the interface, beside the display's own scale
  PanelSizes panels;
  Dialog dialog = Dialog::none;
  std::size_t growth_step = ~std::size_t{0};  ///< which pair of surveys the charts are of, in Tables::growth; beyond its end: the last
  Chart chart = Chart::growth_distribution;   ///< the first one shown
  Chart saved_chart = Chart::growth_distribution;  ///< whose file is being chosen
  PlacementForm placement;
  ExportForm exporting;
  double report_area_ha = 0.0;     ///< 0: of the coverage
  double most_field_checks = 100;  ///< trees on the field check sheet
  ReportSection wanted_section = ReportSection::none;  ///< to be opened and scrolled to
  PageForm page;                   ///< in the dialog `pages`
};

}  // namespace stemwise::ui
