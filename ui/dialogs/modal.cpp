#include "ui/dialogs/modal.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace stemwise::ui {

Modal::Modal(Widgets& w, const char* title, float width, float height, bool& open, Place place) {
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size{std::min(w.px(width), screen.x - w.px(32)), height > 0.0f ? std::min(w.px(height), screen.y - w.px(32)) : 0.0f};
  const float middle = std::max(0.46f * screen.y, 0.5f * size.y + w.px(8));  // a tall one does not leave the window at its top
  const bool hangs = place == Place::top;
  ImGui::SetNextWindowPos({0.5f * screen.x, hangs ? std::round(0.14f * screen.y) : middle}, ImGuiCond_Always, {0.5f, hangs ? 0.0f : 0.5f});
  ImGui::SetNextWindowSize(size, ImGuiCond_Always);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {w.px(20), w.px(16)});
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  if (height <= 0.0f) flags |= ImGuiWindowFlags_AlwaysAutoResize;
  visible_ = ImGui::BeginPopupModal(title, nullptr, flags);
  ImGui::PopStyleVar();
  if (!visible_) return;
  const Rect head = w.next_rect(w.available_width(), w.px(26));
  w.text_in({head.x, head.y, head.width - w.px(30), head.height}, title, TextRole::title, Tone::text);
  const std::string path = std::string("dialog/") + title + "/close";
  if (w.button_in({head.right() - w.px(24), head.y, w.px(24), w.px(24)}, path, "", {.quiet = true, .icon = icon::cross, .tooltip = "Close  (Esc)"})) open = false;
  // A list that is open inside the dialog takes Escape for itself; it may have closed before this line is reached.
  ImGuiStorage* const memory = ImGui::GetStateStorage();
  const ImGuiID inner = ImGui::GetID("inner list");
  const bool list_was_open = memory->GetBool(inner);
  memory->SetBool(inner, GImGui->OpenPopupStack.Size > GImGui->BeginPopupStack.Size);
  if (!list_was_open && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) open = false;
  ImGui::SetCursorScreenPos({head.x, head.bottom() + w.px(8)});
  if (!open) ImGui::CloseCurrentPopup();
}

Modal::~Modal() {
  if (visible_) ImGui::EndPopup();
}

}  // namespace stemwise::ui
