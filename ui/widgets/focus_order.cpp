#include "ui/widgets/focus_order.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace stemwise::ui {

void FocusOrder::begin_frame() {
  order_ = std::move(drawn_);
  drawn_.clear();
  focused_ = std::move(focused_now_);
  focused_now_.clear();
  place_ = std::move(place_now_);
  place_now_.clear();
}

void FocusOrder::visit(const std::string& path, bool is_text) {
  const ImGuiID id = ImGui::GetItemID();
  ImGuiWindow* window = GImGui->CurrentWindow;
  const ImGuiWindow* modal = ImGui::GetTopMostPopupModal();
  const bool mouse_only = path.starts_with("splitter/") || path == "viewport" || path == "viewport/slide";
  if (id == 0 || mouse_only || (modal != nullptr && window->RootWindow != modal)) return;
  drawn_.push_back(path);
  if (path == wanted_) {
    wanted_.clear();
    ImGui::FocusWindow(window);
    ImGui::SetFocusID(id, window);
    GImGui->NavDisableHighlight = false;
    GImGui->NavDisableMouseHover = true;
    if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    if (is_text) {
      GImGui->NavInputSource = ImGuiInputSource_Keyboard;
      ImGui::ActivateItem(id);
    }
  }
  if (GImGui->NavId != id) return;
  place_now_ = path;
  if (!GImGui->NavDisableHighlight) focused_now_ = path;
}

void FocusOrder::move(bool forward) {
  if (order_.empty()) return;
  if (GImGui->ActiveId != 0) ImGui::ClearActiveID();  // a text field is left
  const auto at = std::find(order_.begin(), order_.end(), place_);
  const std::size_t n = order_.size(), here = static_cast<std::size_t>(at - order_.begin());
  wanted_ = at == order_.end() ? (forward ? order_.front() : order_.back()) : order_[(here + (forward ? 1 : n - 1)) % n];
}

}  // namespace stemwise::ui
