#include "ui/actions/keys.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <utility>

namespace stemwise::ui {
namespace {

bool typed(char32_t character) {
  for (const ImWchar c : ImGui::GetIO().InputQueueCharacters) {
    if (c == character) return true;
  }
  return false;
}

bool pressed(const Action& a) {
  if (a.id == ActionId::help_keys) return typed('?');
  const ImGuiIO& io = ImGui::GetIO();
  const bool shift = io.KeyShift && a.chord.key != key('=');  // plus is written with Shift on many keyboards
  if (a.chord.key == Key::none || io.KeyCtrl != a.chord.ctrl || shift != a.chord.shift || io.KeyAlt != a.chord.alt) return false;
  return ImGui::IsKeyPressed(static_cast<int>(a.chord.key), false);
}

bool belongs_to_text_field(const Action& a) {
  if (!a.chord.ctrl) return true;
  return a.id == ActionId::edit_undo || a.id == ActionId::edit_redo;
}

/// Space presses the focused control; only without one does it blink.
bool taken_by_focus(const Action& a) { return a.chord == KeyChord{Key::space} && !GImGui->NavDisableHighlight && GImGui->NavId != 0; }

}  // namespace

bool is_typing() { return GImGui->ActiveId != 0 && GImGui->ActiveId == GImGui->InputTextState.ID; }

void ActionKeys::run(const Availabilities& available, Requests& requests, bool in_dialog) {
  const auto run_one = [&](ActionId id) {
    const Availability& one = available[static_cast<std::size_t>(id)];
    if (one.enabled()) requests.run(id);
    else requests.emit(request::Explain{id, one.why_not});
  };
  for (const ActionId id : std::exchange(waiting_, {})) run_one(id);
  const bool typing = is_typing();
  for (const Action& a : all_actions()) {
    if ((in_dialog && a.id != ActionId::file_quit) || !pressed(a) || (typing && belongs_to_text_field(a)) || taken_by_focus(a)) continue;
    if (a.chord.alt) GImGui->NavWindowingToggleLayer = false;  // letting Alt go then does not lead into the menu bar
    if (typing) waiting_.push_back(a.id);
    else run_one(a.id);
  }
  if (!waiting_.empty()) ImGui::ClearActiveID();
}

}  // namespace stemwise::ui
