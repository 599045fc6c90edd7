#include "ui/dialogs/small_dialogs.hpp"

#include <imgui.h>

#include "ui/dialogs/modal.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

void draw_key_line(Widgets& w, const Action& a) {
  const Rect row = w.next_rect(w.available_width() - w.px(8), w.px(22));
  w.text_in({row.x, row.y, row.width - w.px(96), row.height}, a.label, TextRole::table, Tone::text);
  w.text_in(row, to_string(a.chord), TextRole::table, Tone::secondary, Align::right);
  ImGui::Dummy({row.width, row.height});
  w.record(std::string("keys/") + a.name, row, to_string(a.chord));
}

void draw_key_menu(Widgets& w, Menu menu) {
  w.text(menu_label(menu), TextRole::strong);
  for (const Action& a : all_actions()) {
    if (a.menu == menu) draw_key_line(w, a);
  }
  w.gap(14);
}

}  // namespace

void draw_keys_sheet(Widgets& w, Frame& frame) {
  bool open = true;
  const Modal modal(w, "All keys", 960.0f, 640.0f, open);
  if (!open) frame.view.dialog = Dialog::none;
  if (!modal) return;
  const Menu columns[3][4] = {{Menu::file, Menu::edit, Menu::align, Menu::help}, {Menu::view, Menu::view, Menu::view, Menu::view}, {Menu::review, Menu::export_, Menu::export_, Menu::export_}};
  const int counts[] = {4, 1, 2};
  const float width = (w.available_width() - w.px(48)) / 3.0f;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, w.px(1)});
  for (int c = 0; c < 3; ++c) {
    if (c > 0) ImGui::SameLine(0, w.px(24));
    ImGui::PushID(c);
    ImGui::BeginChild("column", {width, 0});
    for (int k = 0; k < counts[c]; ++k) draw_key_menu(w, columns[c][k]);
    ImGui::EndChild();
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
}

void draw_about(Widgets& w, Frame& frame) {
  bool open = true;
  const Modal modal(w, "About Stemwise", 460.0f, 0.0f, open);
  if (!open) frame.view.dialog = Dialog::none;
  if (!modal) return;
  w.paragraph("Stemwise " + frame.status.version, TextRole::strong);
  w.paragraph("Multi-year forest inventories, aligned without GNSS, point clouds, plot centres or a first guess. The engine is TreeLoc++.", TextRole::body, Tone::secondary);
  w.gap(6);
  w.paragraph("Free software under the MIT licence. Built with Dear ImGui, GLFW, VTK, Eigen, Ceres, nanoflann, GDAL, PROJ, GeographicLib, cairo and pango.", TextRole::table, Tone::secondary);
  w.paragraph("Drawing by " + frame.status.renderer, TextRole::table, Tone::secondary);
}

void draw_history(Widgets& w, Frame& frame) {
  bool open = true;
  const Modal modal(w, "Undo history", 480.0f, 480.0f, open);
  if (!open) frame.view.dialog = Dialog::none;
  if (!modal) return;
  const std::vector<std::string> labels = frame.project.history_labels();
  const std::size_t now = frame.project.history_position();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::BeginChild("entries", {0, 0});
  for (std::size_t i = labels.size() + 1; i-- > 0;) {
    const Rect row = w.next_rect(w.available_width(), w.px(28));
    if (i == now) w.fill(row, w.tokens().accent_soft, w.px(6));
    const std::string label = i == 0 ? "The project as it was opened" : labels[i - 1];
    if (w.area("history/" + std::to_string(i), row, label)) frame.requests.emit(request::GoToHistory{i});
    w.text_in({row.x + w.px(10), row.y, row.width - w.px(90), row.height}, label, TextRole::body, i > now ? Tone::faint : Tone::text);
    w.text_in({row.x, row.y, row.width - w.px(10), row.height}, i == now ? "now" : i > now ? "undone" : "", TextRole::caption, Tone::secondary, Align::right);
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void draw_recovery(Widgets& w, Frame& frame) {
  bool open = true;
  const Modal modal(w, "Bring back unsaved work?", 460.0f, 0.0f, open);
  if (!modal) return;
  w.paragraph(frame.status.recovery_text, TextRole::body);
  w.paragraph("Stemwise did not close in the usual way. What was kept by autosave can be opened; your project file is as you last saved it.", TextRole::body, Tone::secondary);
  w.gap(8);
  if (w.button("recover/yes", "Bring it back", {.primary = true})) frame.requests.emit(request::Recover{true});
  ImGui::SameLine();
  if (w.button("recover/no", "Throw it away")) frame.requests.emit(request::Recover{false});
}

void draw_leave(Widgets& w, Frame& frame) {
  bool open = true;
  const Modal modal(w, "Save changes first?", 460.0f, 0.0f, open);
  if (!open) frame.view.dialog = Dialog::none;
  if (!modal) return;
  w.paragraph("\"" + frame.status.project_title + "\" has changes that are not in its file.", TextRole::body);
  w.gap(8);
  if (w.button("leave/save", "Save", {.primary = true})) frame.requests.emit(request::Leave{true});
  ImGui::SameLine();
  if (w.button("leave/discard", "Don't save")) frame.requests.emit(request::Leave{false});
  ImGui::SameLine();
  if (w.button("leave/cancel", "Stay")) frame.view.dialog = Dialog::none;
}

}  // namespace stemwise::ui
