#pragma once
#include "ui/actions/action.hpp"
#include "ui/requests.hpp"

namespace stemwise::ui {

/// Runs the actions whose keys went down in this frame; not while text is being typed. Chords with Ctrl work there too,
/// except those that text fields use themselves (Ctrl+Z, Ctrl+Y).
void run_keys(const Availabilities& available, Requests& requests);

/// A text field has the keyboard. True only until the frame that ends it: ImGui's WantTextInput lags one behind.
bool is_typing();

}  // namespace stemwise::ui
