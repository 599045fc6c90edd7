#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Shows a chart that `app` paints: asks for it at this size, tells what the mouse is over, selects trees by a click.
void draw_chart(Widgets& w, Frame& frame, Chart chart, const Rect& rect, const std::string& path);

}  // namespace stemwise::ui
