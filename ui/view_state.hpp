#pragma once
#include <optional>
#include <set>
#include <string>

#include "core/base/ids.hpp"
#include "core/survey/fate.hpp"
#include "ui/queue_filter.hpp"
#include "ui/theme/style.hpp"

namespace stemwise::ui {

enum class Step { inventories = 1, align, review, merge, report };
enum class ViewMode { map, space };
enum class Tool { select, rectangle, measure, link, swap, merge };
enum class Heat { none, density, times_seen, residual };
enum class ColorBy { inventory, fate, dbh, growth, residual, confidence, times_seen };
enum class BottomTab { queue, matches, growth, log, jobs };
enum class Dialog { none, open_project, add_inventories, import_inventories, import, save_project, export_path, report_path, palette, keys, about, history, recover, leave, question };

/// What is laid over the map and the 3D view.
struct Layers {
  bool links = true;
  bool coverage = true;
  bool grid = true;
  bool ground = true;
  bool labels = false;
  bool residuals = false;  ///< arrows from sighting to sighting, lengthened
  bool operator==(const Layers&) const = default;
};

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
  std::set<InventoryId> hidden;
  std::optional<Fate> only_fate;   ///< the map and the tables show only these
  TreeId selected_tree;
  StemRef selected_stem;           ///< of the selected tree: Unlink takes it out, Accept and Reject decide on its match
  InventoryId selected_inventory;
  std::vector<TreeId> group;       ///< several trees selected together, ascending; decisions mean all of them
  StemRef link_from;               ///< while the tools link, swap and merge wait for the second stem
  QueueFilter queue;
  Heat heat = Heat::none;
  bool blink = false;
  bool slide = false;              ///< the last two surveys side by side, with a bar to drag between them
  float slide_at = 0.5f;           ///< of the picture's width: left of it the earlier survey, right of it the later one
  ThemeName theme = ThemeName::light;
  bool reduce_motion = false;
  double zoom_percent = 100.0;     ///< of the interface, beside the display's own scale
  PanelSizes panels;
  Dialog dialog = Dialog::none;
};

}  // namespace stemwise::ui
