#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The underlays in the popup of layers: each with its switch, opacity, heights, and the way out.
void draw_underlays(Widgets& w, Frame& frame);

}  // namespace stemwise::ui
