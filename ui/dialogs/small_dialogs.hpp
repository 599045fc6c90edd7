#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Every action with its key.
void draw_keys_sheet(Widgets& w, Frame& frame);
void draw_about(Widgets& w, Frame& frame);
/// All changes in order; a click goes there.
void draw_history(Widgets& w, Frame& frame);
/// After a crash: what autosave has kept.
void draw_recovery(Widgets& w, Frame& frame);
/// Leaving with changes that were not saved (quit, or another project).
void draw_leave(Widgets& w, Frame& frame);
/// The question of the status, with two answers or three; Escape is no.
void draw_question(Widgets& w, Frame& frame);

}  // namespace stemwise::ui
