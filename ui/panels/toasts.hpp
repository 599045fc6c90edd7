#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The notice's buttons in one line.
void draw_choices(Widgets& w, Frame& frame, const Notice& notice, const std::string& path);
/// The newest notices over the lower right corner of `area`: notes go by themselves, errors stay until put away.
void draw_toasts(Widgets& w, Frame& frame, const Rect& area);

}  // namespace stemwise::ui
