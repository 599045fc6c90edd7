#include "ui/dialogs/small_dialogs.hpp"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "ui/dialogs/modal.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

void draw_key_line(Widgets& w, const Action& a) {
  const Rect row = w.next_rect(w.available_width() - w.px(8), w.px(21));
  const float key_width = w.text_width(to_string(a.chord), TextRole::table) + 1.0f;
  w.text_in({row.x, row.y, row.width - key_width - w.px(8), row.height}, a.label, TextRole::table, Tone::text);
  w.text_in(row, to_string(a.chord), TextRole::table, Tone::secondary, Align::right);
  ImGui::Dummy({row.width, row.height});
  w.record(std::string("keys/") + a.name, row, to_string(a.chord));
}

/// Where the columns begin, and where the last one ends: after an equal share of the lines each, heads included.
std::vector<std::size_t> column_starts(std::size_t columns) {
  const std::size_t lines = action_count + 2 * menu_count;
  std::vector<std::size_t> starts(columns + 1, action_count);
  starts[0] = 0;
  std::size_t line = 0, column = 1;
  for (std::size_t i = 0; i < action_count; ++i) {
    const bool head = i == 0 || all_actions()[i].menu != all_actions()[i - 1].menu;
    line += head ? 3 : 1;
    if (column < columns && line > column * lines / columns) starts[column++] = i;
  }
  return starts;
}

}  // namespace

void draw_keys_sheet(Widgets& w, Frame& frame) {
  bool open = true;
  const Modal modal(w, "All keys", 1220.0f, 650.0f, open);
  if (!open) frame.view.dialog = Dialog::none;
  if (!modal) return;
  const std::size_t columns = w.available_width() < w.px(1080) ? 3 : 4;
  const std::vector<std::size_t> starts = column_starts(columns);
  const float width = (w.available_width() - w.px(24) * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, w.px(1)});
  for (std::size_t c = 0; c < columns; ++c) {
    if (c > 0) ImGui::SameLine(0, w.px(24));
    ImGui::PushID(static_cast<int>(c));
    ImGui::BeginChild("column", {width, 0});
    for (std::size_t i = starts[c]; i < starts[c + 1]; ++i) {
      const Action& a = all_actions()[i];
      const bool head = i == starts[c] || a.menu != all_actions()[i - 1].menu;
      if (head && i > starts[c]) w.gap(12);
      if (head) w.text(menu_label(a.menu), TextRole::strong);
      draw_key_line(w, a);
    }
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
  const std::vector<std::string> labels = frame.project.history_labels();
  const float height = std::min(78.0f + 28.0f * static_cast<float>(labels.size() + 1), 560.0f);  // as high as the list, up to a limit
  const Modal modal(w, "Undo history", 480.0f, height, open);
  if (!open) frame.view.dialog = Dialog::none;
  if (!modal) return;
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
  const auto answer = [&](RecoveryAnswer a) { frame.requests.emit(request::Recover{a}); };
  if (!open) answer(RecoveryAnswer::not_now);
  if (!modal) return;
  w.paragraph(frame.status.recovery_text, TextRole::body);
  w.paragraph("Stemwise did not close in the usual way, but autosave has kept your work. Bringing it back changes no file of yours; undo starts anew from there.",
              TextRole::body, Tone::secondary);
  w.gap(8);
  const Rect row = w.next_rect(w.available_width(), w.px(30));
  if (w.button("recover/yes", "Bring it back", {.primary = true})) answer(RecoveryAnswer::bring_back);
  ImGui::SameLine();
  if (w.button("recover/later", "Not now", {.tooltip = "It is kept, and offered again when Stemwise starts or this project is opened"})) answer(RecoveryAnswer::not_now);
  const float width = w.px(132);  // far from the other ones: what is thrown away is gone
  if (w.button_in({row.right() - width, row.y, width, row.height}, "recover/no", "Throw it away…")) answer(RecoveryAnswer::throw_away);
}

void draw_question(Widgets& w, Frame& frame) {
  if (!frame.status.question) {
    frame.view.dialog = Dialog::none;
    return;
  }
  const Question& question = *frame.status.question;
  bool open = true;
  const Modal modal(w, question.title.c_str(), 460.0f, 0.0f, open);
  const auto answer = [&](Answer a) { frame.requests.emit(request::AnswerQuestion{a}); };
  if (!open) answer(Answer::no);
  if (!modal) return;
  w.paragraph(question.text, TextRole::body);
  w.gap(8);
  const bool has_other = !question.other.empty();
  if (has_other && w.button("question/other", question.other, {.primary = true})) answer(Answer::other);
  if (has_other) ImGui::SameLine();
  if (w.button("question/no", question.no, {.primary = !has_other})) answer(Answer::no);
  ImGui::SameLine();
  if (w.button("question/yes", question.yes)) answer(Answer::yes);
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
