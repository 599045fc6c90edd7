#include "ui/dialogs/page_preview.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ui/dialogs/modal.hpp"

namespace stemwise::ui {
namespace {

/// One of the two buttons, or its key.
bool turns(Widgets& w, const char* path, const char* label, const std::string& key, Key code, const std::string& why_not) {
  const bool clicked = w.button(path, label, {.key = key, .why_not = why_not});
  return clicked || (why_not.empty() && ImGui::IsKeyPressed(static_cast<int>(code)));
}

/// Buttons and where one is. True when the page was turned.
bool draw_bar(Widgets& w, PageForm& form, int pages) {
  const int before = form.page;
  const Rect row = w.next_rect(w.available_width(), w.px(30));
  if (turns(w, "pages/previous", "Previous", "Page Up", Key::page_up, form.page == 0 ? "This is the first page" : "")) --form.page;
  ImGui::SameLine();
  if (turns(w, "pages/next", "Next", "Page Down", Key::page_down, form.page + 1 >= pages ? "This is the last page" : "")) ++form.page;
  const std::string where = pages == 0 ? "" : "Page " + std::to_string(form.page + 1) + " of " + std::to_string(pages);
  w.text_in(row, where, TextRole::body, Tone::secondary, Align::right);
  w.record("pages/where", row, where);
  ImGui::SetCursorScreenPos({row.x, row.bottom() + w.px(8)});
  return form.page != before;
}

void draw_page(Widgets& w, const PageView& view) {
  const Rect rect = w.next_rect(static_cast<float>(view.width_px), static_cast<float>(view.height_px));
  const float x = std::round(rect.x), y = std::round(rect.y);
  ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(view.texture)), {rect.width, rect.height});
  w.outline({x, y, rect.width, rect.height}, w.tokens().line);
  w.record("pages/page", rect, std::to_string(view.form.page + 1));
}

}  // namespace

void draw_page_preview(Widgets& w, Frame& frame) {
  PageForm& form = frame.view.page;
  bool open = true;
  const Modal modal(w, form.sheet == PrintedSheet::report ? "Growth report, as it will be printed" : "Field check sheet, as it will be printed", 780.0f, 4000.0f, open);
  if (!open) frame.view.dialog = Dialog::none;
  if (!modal) return;
  const std::optional<PageView>& view = frame.status.page;
  const bool is_of_this = view && view->form.sheet == form.sheet && view->revision == frame.revision;
  const bool turned = draw_bar(w, form, is_of_this ? view->pages : 0);
  const Rect room = w.next_rect(w.available_width(), ImGui::GetContentRegionAvail().y);
  form.width_px = static_cast<int>(room.width - w.px(14));
  form.area_ha = frame.view.report_area_ha;
  form.most_trees = static_cast<int>(std::clamp(frame.view.most_field_checks, 1.0, 100000.0));
  w.fill(room, w.tokens().canvas, w.px(6));
  ImGui::BeginChild("page", {room.width, room.height});
  if (turned) ImGui::SetScrollY(0.0f);
  if (is_of_this) draw_page(w, *view);
  else w.text("Drawing the pages\u2026", TextRole::body, Tone::secondary);
  ImGui::EndChild();
}

}  // namespace stemwise::ui
