#include "ui/actions/action.hpp"

#include <stdexcept>

namespace stemwise::ui {
namespace {

constexpr KeyChord plain(char c) { return {key(c)}; }
constexpr KeyChord ctrl(char c) { return {key(c), true}; }
constexpr KeyChord ctrl_shift(char c) { return {key(c), true, true}; }
constexpr KeyChord shift(char c) { return {key(c), false, true}; }
constexpr KeyChord alt(char c) { return {key(c), false, false, true}; }

using enum ActionId;

constexpr std::array<Action, action_count> table{{
    {file_new, "file.new", "New project", Menu::file, ctrl('N'), "Starts an empty project."},
    {file_open, "file.open", "Open project…", Menu::file, ctrl('O'), "Opens a project file (GeoPackage)."},
    {file_add, "file.add", "Add inventories…", Menu::file, ctrl('I'), "Reads stem lists, tables or frame folders into the project.", true},
    {file_import, "file.import", "Import with options…", Menu::file, ctrl_shift('I'), "Shows how files will be understood before they are taken: columns, units, date, coordinates, status codes."},
    {file_underlay, "file.underlay", "Add underlay…", Menu::file, ctrl('U'), "Lays an image, a terrain or a point cloud under the stems: GeoTIFF, PNG, JPEG, LAS, PCD or PLY."},
    {file_demo, "file.demo", "Open the demo", Menu::file, ctrl('D'), "A simulated forest surveyed in three years, to try everything on."},
    {file_save, "file.save", "Save", Menu::file, ctrl('S'), "Writes the project file; the old one is replaced only by a complete one.", true},
    {file_save_as, "file.save_as", "Save as…", Menu::file, ctrl_shift('S'), "Writes the project under another name."},
    {file_quit, "file.quit", "Quit", Menu::file, ctrl('Q'), "Closes the window.", true},
    {edit_undo, "edit.undo", "Undo", Menu::edit, ctrl('Z'), "Takes back the last change; as often as you like."},
    {edit_redo, "edit.redo", "Redo", Menu::edit, ctrl('Y'), "Does again what was taken back."},
    {edit_history, "edit.history", "Undo history…", Menu::edit, ctrl('H'), "Every change in order; click one to go there."},
    {edit_make_reference, "edit.make_reference", "Make reference", Menu::edit, ctrl_shift('R'), "The selected inventory becomes the one that all others are aligned to.", true},
    {edit_remove_inventory, "edit.remove_inventory", "Remove inventory", Menu::edit, ctrl_shift('X'), "Takes the selected inventory out of the project; its file stays."},
    {edit_coverage, "edit.coverage", "Draw the coverage…", Menu::edit, ctrl_shift('C'), "Click the corners of the ground where the selected survey looked."},
    {view_mode, "view.mode", "Map or 3D", Menu::view, plain('M'), "Changes between the map and the 3D view."},
    {view_fit, "view.fit", "Show everything", Menu::view, {Key::home}, "Fits all stems into the view."},
    {view_focus, "view.focus", "Focus on the selected tree", Menu::view, plain('F'), "Flies to the selected tree."},
    {view_blink, "view.blink", "Blink between surveys", Menu::view, {Key::space}, "Shows the first and the last survey in turn."},
    {view_slide, "view.slide", "Slide between surveys", Menu::view, plain('C'), "The last two surveys in one picture, with a bar to drag between them."},
    {view_before_after, "view.before_after", "Before and after alignment", Menu::view, plain('V'), "The selected survey as it was given and as it was aligned, with a bar to drag between them."},
    {view_ghost, "view.ghost", "Second-best pose", Menu::view, plain('G'), "Shows the selected survey a second time, hollow, where it would fit next best."},
    {view_links, "view.links", "Match links", Menu::view, alt('L'), "Lines between stems that are held to be one tree.", true},
    {view_residuals, "view.residuals", "Residual arrows", Menu::view, alt('R'), "From each sighting to the next, lengthened so that the pattern shows."},
    {view_coverage, "view.coverage", "Coverage", Menu::view, alt('C'), "Where each survey looked."},
    {view_grid, "view.grid", "Grid", Menu::view, alt('G'), "A grid in metres."},
    {view_labels, "view.labels", "Tree labels", Menu::view, alt('T'), "Tree numbers where there is room."},
    {view_underlays, "view.underlays", "Underlays", Menu::view, alt('U'), "Images and point clouds under the stems."},
    {view_left, "view.left", "Inventories panel", Menu::view, {Key::f6}, "Folds the left panel away.", true},
    {view_right, "view.right", "Inspector panel", Menu::view, {Key::f7}, "Folds the right panel away."},
    {view_bottom, "view.bottom", "Tables panel", Menu::view, {Key::f8}, "Folds the lower panel away."},
    {view_theme, "view.theme", "Dark theme", Menu::view, ctrl_shift('D'), "Changes between the light and the dark theme.", true},
    {view_reduce_motion, "view.reduce_motion", "Reduce motion", Menu::view, ctrl_shift('M'), "Jumps instead of flying."},
    {view_zoom_in, "view.zoom_in", "Larger text", Menu::view, ctrl('='), "Makes everything larger."},
    {view_zoom_out, "view.zoom_out", "Smaller text", Menu::view, ctrl('-'), "Makes everything smaller."},
    {color_inventory, "color.inventory", "Colour by inventory", Menu::view, alt('1'), "One colour per survey.", true},
    {color_fate, "color.fate", "Colour by fate", Menu::view, alt('2'), "What became of each tree."},
    {color_dbh, "color.dbh", "Colour by DBH", Menu::view, alt('3'), "Diameter at breast height."},
    {color_growth, "color.growth", "Colour by DBH change", Menu::view, alt('4'), "Grown, shrunken, or within the error."},
    {color_residual, "color.residual", "Colour by residual", Menu::view, alt('5'), "How far a tree's stems lie apart."},
    {color_confidence, "color.confidence", "Colour by confidence", Menu::view, alt('6'), "How sure the matches are."},
    {color_times_seen, "color.times_seen", "Colour by times seen", Menu::view, alt('7'), "In how many surveys a tree was seen."},
    {heat_density, "heat.density", "Heat map of stem density", Menu::view, alt('8'), "Stems per hectare under the marks; again: none.", true},
    {heat_times_seen, "heat.times_seen", "Heat map of times seen", Menu::view, alt('9'), "In how many surveys the trees around were seen."},
    {heat_residual, "heat.residual", "Heat map of residuals", Menu::view, alt('0'), "How far the stems of one tree lie apart, averaged over the trees around."},
    {tool_select, "tool.select", "Select", Menu::view, plain('S'), "A click selects a tree everywhere; Ctrl adds one, Shift and a drag takes a rectangle.", true},
    {tool_rectangle, "tool.rectangle", "Select in a rectangle", Menu::view, plain('B'), "Drag a rectangle: decisions then mean all trees in it."},
    {tool_lasso, "tool.lasso", "Select in a polygon", Menu::view, plain('O'), "Click the corners around trees, then Enter: decisions then mean all trees in it."},
    {tool_measure, "tool.measure", "Measure", Menu::view, plain('D'), "Distance and azimuth between two points."},
    {step_inventories, "step.inventories", "Step 1: inventories", Menu::view, plain('1'), "Add and check the surveys.", true},
    {step_align, "step.align", "Step 2: align", Menu::view, plain('2'), "Find how the surveys lie on each other."},
    {step_review, "step.review", "Step 3: review", Menu::view, plain('3'), "Check and correct the matches."},
    {step_merge, "step.merge", "Step 4: merge and georeference", Menu::view, plain('4'), "One inventory, on the earth."},
    {step_report, "step.report", "Step 5: report and export", Menu::view, plain('5'), "Deliver it."},
    {align_run, "align.run", "Align", Menu::align, ctrl('R'), "Finds how the surveys lie on each other and which stem is which."},
    {align_cancel, "align.cancel", "Cancel the running job", Menu::align, {Key::escape, false, true}, "Stops what is running; nothing changes."},
    {align_accept_probable, "align.accept_probable", "Accept the probable pose", Menu::align, ctrl_shift('A'), "Takes the proposed pose of the selected inventory as aligned."},
    {review_next, "review.next", "Next doubtful tree", Menu::review, plain('N'), "Goes to the most doubtful undecided tree after this one."},
    {review_previous, "review.previous", "Previous doubtful tree", Menu::review, plain('P'), "Goes back in the queue."},
    {review_go_on, "review.go_on", "Go on after each decision", Menu::review, shift('G'), "A decision on a tree in doubt leads to the next one at once; the decision before is a Ctrl+Z away."},
    {review_accept, "review.accept", "Accept", Menu::review, plain('A'), "These stems are one tree; also in later runs.", true},
    {review_reject, "review.reject", "Reject", Menu::review, plain('R'), "These stems are different trees; also in later runs."},
    {review_link, "review.link", "Link to…", Menu::review, plain('L'), "Click the stem that is the same tree."},
    {review_unlink, "review.unlink", "Unlink", Menu::review, plain('U'), "Takes the selected stem out of its tree."},
    {review_swap, "review.swap", "Swap with…", Menu::review, shift('S'), "Click a stem of the same survey: the two change trees."},
    {review_split, "review.split", "Split here", Menu::review, shift('U'), "The selected stem and all later ones become a tree of their own."},
    {review_merge, "review.merge", "Merge with…", Menu::review, shift('L'), "Click another tree: both become one."},
    {review_dead, "review.dead", "Mark as dead", Menu::review, shift('D'), "The tree was found dead.", true},
    {review_removed, "review.removed", "Mark as removed", Menu::review, shift('R'), "The tree was felled or taken away."},
    {review_missed_earlier, "review.missed_earlier", "Mark as missed earlier", Menu::review, shift('M'), "The tree stood there before, but was not recorded."},
    {review_ingrowth, "review.ingrowth", "Mark as ingrowth", Menu::review, shift('I'), "The tree has grown over the threshold."},
    {review_clear_fate, "review.clear_fate", "Clear the fate set by hand", Menu::review, shift('C'), "The computed fate counts again."},
    {review_region, "review.region", "Only what the map shows", Menu::review, shift('V'), "The queue keeps to the trees in the map's view, also for N; again: to all.", true},
    {review_clear_filters, "review.clear_filters", "Clear the queue's filters", Menu::review, shift('N'), "All rows of the queue again."},
    {export_run, "export.run", "Export…", Menu::export_, ctrl('E'), "Writes trees, observations, matches or coverage to a file."},
    {export_report, "export.report", "Growth report…", Menu::export_, ctrl_shift('E'), "Writes the growth report."},
    {export_preview_report, "export.preview_report", "Look at the growth report…", Menu::export_, ctrl_shift('P'), "Its pages as they will be printed, before anything is written."},
    {export_field_check, "export.field_check", "Field check sheet…", Menu::export_, ctrl_shift('F'), "Doubtful trees with distance and azimuth from the three nearest sure trees, to take outside."},
    {export_preview_field_check, "export.preview_field_check", "Look at the field check sheet…", Menu::export_, ctrl_shift('K'), "Its pages as they will be printed, before anything is written."},
    {help_palette, "help.palette", "Search or run a command", Menu::help, ctrl('P'), "Finds any action or tree by name."},
    {help_keys, "help.keys", "All keys", Menu::help, {Key::slash, false, true}, "Every action with its key."},
    {help_about, "help.about", "About Stemwise", Menu::help, {Key::f1}, "Version, licence and sources."},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].id != static_cast<ActionId>(i)) return false;
  }
  return true;
}
static_assert(in_order(), "one entry per ActionId, in its order");

std::string key_name(Key k) {
  switch (k) {
    case Key::none: return "";
    case Key::space: return "Space";
    case Key::escape: return "Esc";
    case Key::enter: return "Enter";
    case Key::up: return "Up";
    case Key::down: return "Down";
    case Key::home: return "Home";
    default: break;
  }
  const int code = static_cast<int>(k);
  if (code >= static_cast<int>(Key::f1)) return "F" + std::to_string(code - static_cast<int>(Key::f1) + 1);
  if (code == '=') return "+";
  if (code == '-') return "−";
  return std::string(1, static_cast<char>(code));
}

}  // namespace

std::string to_string(KeyChord chord) {
  if (chord.key == Key::slash && chord.shift) return "?";
  std::string text;
  if (chord.ctrl) text += "Ctrl+";
  if (chord.alt) text += "Alt+";
  if (chord.shift) text += "Shift+";
  return text + key_name(chord.key);
}

const char* menu_label(Menu menu) {
  switch (menu) {
    case Menu::file: return "File";
    case Menu::edit: return "Edit";
    case Menu::view: return "View";
    case Menu::align: return "Align";
    case Menu::review: return "Review";
    case Menu::export_: return "Export";
    case Menu::help: return "Help";
  }
  throw std::logic_error("menu_label: unknown menu");
}

std::span<const Action> all_actions() { return table; }

const Action& action(ActionId id) { return table.at(static_cast<std::size_t>(id)); }

std::string label_with_key(ActionId id) {
  const Action& a = action(id);
  const std::string chord = to_string(a.chord);
  return chord.empty() ? a.label : std::string(a.label) + " (" + chord + ")";
}

}  // namespace stemwise::ui
