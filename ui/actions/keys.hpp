#pragma once
#include "ui/actions/action.hpp"
#include "ui/requests.hpp"

namespace stemwise::ui {

/// Runs the actions whose keys went down in this frame; not while text is being typed. Chords with Ctrl work there too,
/// except those that text fields use themselves (Ctrl+Z, Ctrl+Y).
void run_keys(const Availabilities& available, Requests& requests);

}  // namespace stemwise::ui
