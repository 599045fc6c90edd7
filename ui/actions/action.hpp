#pragma once
#include <array>
#include <span>
#include <string>

namespace stemwise::ui {

enum class ActionId {
  file_new, file_open, file_add, file_import, file_underlay, file_demo, file_save, file_save_as, file_quit,
  edit_undo, edit_redo, edit_history, edit_make_reference, edit_remove_inventory, edit_coverage,
  view_mode, view_fit, view_focus, view_blink, view_slide, view_before_after, view_ghost, view_links, view_residuals, view_coverage, view_grid, view_labels, view_underlays,
  view_left, view_right, view_bottom, view_theme, view_reduce_motion, view_zoom_in, view_zoom_out,
  color_inventory, color_fate, color_dbh, color_growth, color_residual, color_confidence, color_times_seen,
  heat_density, heat_times_seen, heat_residual,
  tool_select, tool_rectangle, tool_lasso, tool_measure,
  step_inventories, step_align, step_review, step_merge, step_report,
  align_run, align_cancel, align_accept_probable,
  review_next, review_previous, review_go_on, review_accept, review_reject, review_link, review_unlink,
  review_swap, review_split, review_merge,
  review_dead, review_removed, review_missed_earlier, review_ingrowth, review_clear_fate, review_region, review_clear_filters,
  export_run, export_report, export_preview_report, export_field_check, export_preview_field_check,
  help_palette, help_keys, help_about,
  count
};
inline constexpr std::size_t action_count = static_cast<std::size_t>(ActionId::count);

/// Numbers of keys as GLFW has them (letters and digits are their upper-case ASCII).
enum class Key : int { none = 0, space = 32, slash = 47, escape = 256, enter = 257, down = 264, up = 265, page_up = 266, page_down = 267, home = 268, f1 = 290, f2, f3, f4, f5, f6, f7, f8 };
constexpr Key key(char c) { return static_cast<Key>(c); }

struct KeyChord {
  Key key = Key::none;
  bool ctrl = false;
  bool shift = false;
  bool alt = false;
  bool operator==(const KeyChord&) const = default;
};

/// "Ctrl+Shift+S", "Space", "?"; empty for no key.
std::string to_string(KeyChord chord);

enum class Menu { file, edit, view, align, review, export_, help };
inline constexpr std::size_t menu_count = 7;
const char* menu_label(Menu menu);

/// One thing that a person can ask for, told once: menus, keys, palette, keys sheet and tooltips all read it here.
struct Action {
  ActionId id;
  const char* name;   ///< for scripts: "file.open"
  const char* label;  ///< sentence case; ends with an ellipsis where a dialog follows
  Menu menu;
  KeyChord chord;
  const char* help;   ///< one sentence
  bool separator_before = false;
};

/// All of them, in the order of the menus; index = ActionId.
std::span<const Action> all_actions();
const Action& action(ActionId id);
/// Label with its key: "Accept (A)".
std::string label_with_key(ActionId id);

/// Whether an action can be run now; the reason when not.
struct Availability {
  std::string why_not;
  bool enabled() const { return why_not.empty(); }
};
using Availabilities = std::array<Availability, action_count>;

}  // namespace stemwise::ui
