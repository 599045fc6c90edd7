#include "ui/shell.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/actions/keys.hpp"
#include "ui/dialogs/file_browser.hpp"
#include "ui/dialogs/import_dialog.hpp"
#include "ui/dialogs/page_preview.hpp"
#include "ui/dialogs/palette.hpp"
#include "ui/dialogs/small_dialogs.hpp"
#include "ui/panels/align_panel.hpp"
#include "ui/panels/bottom_panel.hpp"
#include "ui/panels/empty_state.hpp"
#include "ui/panels/inspector.hpp"
#include "ui/panels/inventories_panel.hpp"
#include "ui/panels/inventory_details.hpp"
#include "ui/panels/menu_bar.hpp"
#include "ui/panels/merge_panel.hpp"
#include "ui/panels/report_panel.hpp"
#include "ui/panels/status_bar.hpp"
#include "ui/panels/step_bar.hpp"
#include "ui/panels/toasts.hpp"
#include "ui/panels/viewport_panel.hpp"

namespace stemwise::ui {
namespace {

/// Where everything goes, in pixels.
struct Layout {
  Rect steps, left, middle, right, bottom, status;
};

constexpr float least_middle = 560.0f, least_left = 208.0f, least_right = 300.0f;

/// The tab below has nothing to show yet: one line needs no big panel.
bool is_bottom_empty(const Frame& frame) {
  const Tables& t = frame.tables();
  switch (frame.view.tab) {
    case BottomTab::queue: return t.queue.empty();
    case BottomTab::matches: return t.matches.empty();
    case BottomTab::growth: return t.growth.empty();
    case BottomTab::conflicts: return frame.derived.conflicts.empty();
    case BottomTab::log: return frame.state().edit_log.empty();
    case BottomTab::jobs: return frame.status.jobs.size() < 2 && frame.status.notices.empty();
  }
  return false;
}

Layout lay_out(const Widgets& w, const Frame& frame, float width, float height) {
  const ViewState& view = frame.view;
  const PanelSizes& p = view.panels;
  // Whole pixels: the map's picture is then copied as it is.
  const float top = std::round(w.px(MenuBar::height));
  const float body_top = std::round(top + w.px(StepBar::height));
  const float body_bottom = std::round(height - w.px(StatusBar::height));
  float left = p.show_left ? std::min(w.px(p.left), 0.35f * width) : 0.0f;
  float right = p.show_right ? std::min(w.px(p.right), 0.40f * width) : 0.0f;
  // Large text in a small window: the side panels give way to what is between them, as far as they stay readable.
  const float wanted_middle = w.px(least_middle);
  const auto give_way = [&](float& side, float least) { side = std::max(std::min(side, least), side - std::max(0.0f, wanted_middle - (width - left - right))); };
  give_way(left, w.px(least_left));
  give_way(right, w.px(least_right));
  left = std::round(left);
  right = std::round(right);
  const float wanted = is_bottom_empty(frame) ? std::min(w.px(p.bottom), w.px(108)) : w.px(p.bottom);
  const float bottom = p.show_bottom ? std::round(std::min(wanted, 0.46f * (body_bottom - body_top))) : 0.0f;
  Layout l;
  l.steps = {0, top, width, body_top - top};
  l.left = {0, body_top, left, body_bottom - body_top};
  l.right = {width - right, body_top, right, body_bottom - body_top};
  l.middle = {left, body_top, width - left - right, body_bottom - body_top - bottom};
  l.bottom = {left, body_bottom - bottom, width - left - right, bottom};
  l.status = {0, body_bottom, width, height - body_bottom};
  return l;
}

}  // namespace

struct Shell::Impl {
  Widgets widgets;
  ActionKeys keys;
  Theme applied;
  bool prepared = false;
  Rect viewport;
  MenuBar menu_bar;
  StepBar step_bar;
  InventoriesPanel inventories;
  ViewportPanel viewport_panel;
  Inspector inspector;
  InventoryDetails details;
  AlignPanel align;
  MergePanel merge;
  ReportPanel report;
  BottomPanel bottom;
  StatusBar status_bar;
  EmptyState empty;
  FileBrowser files;
  ImportDialog import;
  Palette palette;
  Dialog browsing = Dialog::none;  ///< which dialog the file browser is open for

  bool leaves_field = false;
  bool enter_was_typed = false;    ///< the Enter key that is down belongs to a text field

  void draw_body(Frame& frame, const Layout& l);
  void begin_side(const char* name, const Rect& rect);
  static void end_side();
  void draw_left(Frame& frame, const Rect& rect);
  void draw_right(Frame& frame, const Rect& rect);
  void draw_splitters(Frame& frame, const Layout& l);
  void draw_dialogs(Frame& frame);
  void start_browsing(Frame& frame);
  void finish_browsing(Frame& frame, const std::vector<std::string>& paths);
};

Shell::Shell() : impl_(std::make_unique<Impl>()) {}
Shell::~Shell() = default;
const WidgetRegistry& Shell::registry() const { return impl_->widgets.registry; }
const std::string& Shell::focused() const { return impl_->widgets.focus.focused(); }
Rect Shell::viewport_rect() const { return impl_->viewport; }

bool Shell::prepare(const ViewState& view, float scale) {
  const Theme wanted{view.theme, scale, view.reduce_motion};
  const bool new_fonts = !impl_->prepared || impl_->widgets.fonts.scale() != wanted.scale;
  if (new_fonts) impl_->widgets.fonts.load(wanted.scale);
  if (new_fonts || !(wanted == impl_->applied)) apply_style(wanted);
  impl_->widgets.theme = impl_->applied = wanted;
  impl_->prepared = true;
  return new_fonts;
}

void Shell::leave_field() { impl_->leaves_field = true; }

void Shell::take_keys() {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyMap[ImGuiKey_Tab] = -1;  // goes through all controls (FocusOrder), not only through text fields
  const bool typing = is_typing();
  io.KeyMap[ImGuiKey_Home] = typing ? static_cast<int>(Key::home) : -1;  // else it would move the focus: it shows everything
  // Enter presses what has the focus, as Space does; not with the stroke that ended a text.
  const bool enter = io.KeysDown[static_cast<int>(Key::enter)];
  if (!enter) impl_->enter_was_typed = false;
  else if (typing) impl_->enter_was_typed = true;
  io.KeyMap[ImGuiKey_Space] = static_cast<int>(enter && !impl_->enter_was_typed ? Key::enter : Key::space);
}

void Shell::draw(Frame& frame) {
  Widgets& w = impl_->widgets;
  w.registry.begin_frame();
  w.focus.begin_frame();
  if (std::exchange(impl_->leaves_field, false)) ImGui::ClearActiveID();
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.KeyCtrl && !io.KeyAlt && ImGui::IsKeyPressed(258)) w.focus.move(!io.KeyShift);
  impl_->keys.run(frame.available, frame.requests, frame.view.dialog != Dialog::none);
  const bool plain = !ImGui::GetIO().KeyShift;  // with Shift, Escape cancels a job
  if (frame.view.dialog == Dialog::none && plain && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    frame.view.tool = Tool::select;
    frame.view.blink = false;
    frame.view.slide = false;
    frame.view.before_after = false;
    frame.view.ghost = false;
    frame.view.link_from = {};
    frame.view.group.clear();
  }
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const Layout layout = lay_out(w, frame, size.x, size.y);
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::Begin("stemwise", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar(3);
  impl_->menu_bar.draw(w, frame);
  impl_->step_bar.draw(w, frame, layout.steps);
  impl_->draw_body(frame, layout);
  impl_->status_bar.draw(w, frame, layout.status);
  impl_->draw_dialogs(frame);
  ImGui::End();
  const Rect stage = frame.state().inventories.empty() ? Rect{0, layout.middle.y, size.x, layout.left.height} : layout.middle;
  draw_toasts(w, frame, stage);
}

void Shell::Impl::draw_body(Frame& frame, const Layout& l) {
  if (frame.state().inventories.empty()) {
    viewport = {};
    empty.draw(widgets, frame, {0, l.left.y, l.right.right(), l.left.height});
    return;
  }
  viewport = l.middle;
  draw_left(frame, l.left);  // in the order in which Tab goes through them
  ImGui::SetCursorScreenPos({l.middle.x, l.middle.y});
  ImGui::BeginChild("middle", {l.middle.width, l.middle.height}, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  viewport_panel.draw(widgets, frame, l.middle);
  ImGui::EndChild();
  draw_right(frame, l.right);
  if (l.bottom.height > 0) {
    widgets.fill(l.bottom, widgets.tokens().panel);
    bottom.draw(widgets, frame, l.bottom);
  }
  widgets.hairline(l.left.right() - 1, l.left.y, l.left.right(), l.left.bottom());
  widgets.hairline(l.right.x, l.right.y, l.right.x + 1, l.right.bottom());
  if (l.bottom.height > 0) widgets.hairline(l.bottom.x, l.bottom.y, l.bottom.right(), l.bottom.y + 1);
  draw_splitters(frame, l);
}

void Shell::Impl::draw_splitters(Frame& frame, const Layout& l) {
  PanelSizes& p = frame.view.panels;
  const float grip = widgets.px(6);
  if (p.show_left) widgets.splitter("splitter/left", {l.left.right() - 0.5f * grip, l.left.y, grip, l.left.height}, true, p.left, 220, 480, false);
  if (p.show_right) widgets.splitter("splitter/right", {l.right.x - 0.5f * grip, l.right.y, grip, l.right.height}, true, p.right, 300, 560, true);
  if (p.show_bottom) widgets.splitter("splitter/bottom", {l.bottom.x + grip, l.bottom.y - 0.5f * grip, l.bottom.width - 2 * grip, grip}, false, p.bottom, 140, 620, true);
}

/// A side panel: 16 px of air on both sides. Its scroll bar stands in that air, so nothing changes its width when it comes.
void Shell::Impl::begin_side(const char* name, const Rect& rect) {
  widgets.fill(rect, widgets.tokens().panel);
  const float grip = widgets.px(3), pad = widgets.px(13);  // the splitter's half lies beside the panel
  const float width = rect.width - 2.0f * grip;
  ImGui::SetCursorScreenPos({rect.x + grip, rect.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, widgets.px(12)});
  ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, widgets.px(7));
  ImGui::SetNextWindowContentSize({width - 2.0f * pad, 0.0f});
  ImGui::BeginChild(name, {width, rect.height}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
}

void Shell::Impl::end_side() {
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
}

void Shell::Impl::draw_left(Frame& frame, const Rect& rect) {
  if (rect.width <= 0) return;
  begin_side("left", rect);
  inventories.draw(widgets, frame);
  end_side();
}

void Shell::Impl::draw_right(Frame& frame, const Rect& rect) {
  if (rect.width <= 0) return;
  ImGui::PushID(static_cast<int>(frame.view.step));
  begin_side("right", rect);
  switch (frame.view.step) {
    case Step::inventories: details.draw(widgets, frame); break;
    case Step::align: align.draw(widgets, frame); break;
    case Step::review: inspector.draw(widgets, frame); break;
    case Step::merge: merge.draw(widgets, frame); break;
    case Step::report: report.draw(widgets, frame); break;
  }
  end_side();
  ImGui::PopID();
}

void Shell::Impl::draw_dialogs(Frame& frame) {
  if (frame.view.dialog != browsing) browsing = Dialog::none;
  switch (frame.view.dialog) {
    case Dialog::none:
      // A modal popup that nobody draws any more would go on blocking the mouse.
      if (ImGui::GetTopMostPopupModal() != nullptr) ImGui::ClosePopupToLevel(0, false);
      break;
    case Dialog::import: import.draw(widgets, frame); break;
    case Dialog::palette: palette.draw(widgets, frame); break;
    case Dialog::keys: draw_keys_sheet(widgets, frame); break;
    case Dialog::about: draw_about(widgets, frame); break;
    case Dialog::history: draw_history(widgets, frame); break;
    case Dialog::recover: draw_recovery(widgets, frame); break;
    case Dialog::leave: draw_leave(widgets, frame); break;
    case Dialog::pages: draw_page_preview(widgets, frame); break;
    case Dialog::question: draw_question(widgets, frame); break;
    default:
      if (!files.is_open() || browsing != frame.view.dialog) start_browsing(frame);
      if (const auto paths = files.draw(widgets)) finish_browsing(frame, *paths);
      if (!files.is_open()) frame.view.dialog = Dialog::none;
      break;
  }
}

void Shell::Impl::start_browsing(Frame& frame) {
  browsing = frame.view.dialog;
  const std::string& title = frame.status.project_title;
  FileBrowserMode mode;
  switch (browsing) {
    case Dialog::open_project: mode = {"Open a project", "Open", {".gpkg"}, false, false, ""}; break;
    case Dialog::add_inventories: mode = {"Add inventories", "Add", {}, false, true, ""}; break;
    case Dialog::import_inventories: mode = {"Import with options", "Look at them", {}, false, true, ""}; break;
    case Dialog::add_underlay: mode = {"Add an underlay", "Add", {".tif", ".tiff", ".png", ".jpg", ".jpeg", ".jp2", ".vrt", ".asc", ".las", ".laz", ".pcd", ".ply"}, false, false, ""}; break;
    case Dialog::save_project: mode = {"Save the project", "Save", {".gpkg"}, true, false, title + ".gpkg"}; break;
    case Dialog::export_path: mode = {"Export to", "Choose", {".gpkg", ".csv", ".xlsx", ".geojson", ".shp", ".kml", ".dxf", ".fgb"}, true, false, title + "-trees.gpkg"}; break;
    case Dialog::field_check_path: mode = {"Write the field check sheet to", "Choose", {".pdf", ".html", ".gpx", ".csv", ".xlsx"}, true, false, title + "-field-check.pdf"}; break;
    case Dialog::chart_path: mode = {"Save the chart", "Save", {".png", ".svg"}, true, false, title + "-" + chart_word(frame.view.saved_chart) + ".png"}; break;
    case Dialog::control_file: mode = {"Control points", "Open", {".csv", ".txt", ".tsv"}, false, false, ""}; break;
    case Dialog::gnss_file: mode = {"GNSS track", "Open", {".csv", ".txt", ".tsv"}, false, false, ""}; break;
    case Dialog::rules_file: mode = {"Own rules", "Open", {".json"}, false, false, ""}; break;
    default: mode = {"Write the report to", "Choose", {".html", ".pdf", ".csv", ".xlsx"}, true, false, title + "-growth.html"}; break;
  }
  const std::string folder = mode.save ? frame.status.project_folder : frame.status.working_folder;
  files.open(std::move(mode), folder, frame.status.home_folder, frame.status.places);
}

void Shell::Impl::finish_browsing(Frame& frame, const std::vector<std::string>& paths) {
  if (paths.empty()) return;
  switch (browsing) {
    case Dialog::open_project: frame.requests.emit(request::OpenProject{paths.front()}); break;
    case Dialog::add_inventories: frame.requests.emit(request::AddInventories{paths}); break;
    case Dialog::import_inventories: frame.requests.emit(request::AddInventories{paths, true}); break;
    case Dialog::add_underlay: frame.requests.emit(request::AddUnderlays{paths}); break;
    case Dialog::save_project: frame.requests.emit(request::SaveProject{paths.front()}); break;
    case Dialog::export_path: report.set_export_path(paths.front()); break;
    case Dialog::field_check_path: report.set_field_check_path(paths.front()); break;
    case Dialog::chart_path: frame.requests.emit(request::SaveChart{frame.view.saved_chart, paths.front()}); break;
    case Dialog::control_file: frame.view.placement.control_file = paths.front(); break;
    case Dialog::gnss_file: frame.view.placement.gnss_file = paths.front(); break;
    case Dialog::rules_file: frame.requests.emit(request::ReadRules{paths.front()}); break;
    default: report.set_report_path(paths.front()); break;
  }
}

}  // namespace stemwise::ui
