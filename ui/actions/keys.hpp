#pragma once
#include <vector>

#include "ui/actions/action.hpp"
#include "ui/requests.hpp"

namespace stemwise::ui {

/// Actions by their keys; not while text is being typed. Chords with Ctrl work there too, except those that text fields use
/// themselves (Ctrl+Z, Ctrl+Y): the field is left first, so that what was typed is in the project when the action runs.
class ActionKeys {
 public:
  /// Once a frame, before the panels are drawn. `in_dialog`: only what leads out of every dialog, Quit.
  void run(const Availabilities& available, Requests& requests, bool in_dialog);

 private:
  std::vector<ActionId> waiting_;  ///< for the field to be left
};

/// A text field has the keyboard. True only until the frame that ends it: ImGui's WantTextInput lags one behind.
bool is_typing();

}  // namespace stemwise::ui
