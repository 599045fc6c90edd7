#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The growth report or the field check sheet, page by page as it would be printed.
void draw_page_preview(Widgets& w, Frame& frame);

}  // namespace stemwise::ui
