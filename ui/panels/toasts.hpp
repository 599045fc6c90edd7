#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The newest notices over the lower right corner of `area`: notes go by themselves, errors stay until put away.
void draw_toasts(Widgets& w, Frame& frame, const Rect& area);

}  // namespace stemwise::ui
