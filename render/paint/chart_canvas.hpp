#pragma once
#include "render/chart_painter.hpp"
#include "render/paint/canvas.hpp"

namespace stemwise::render {

/// Paints a chart on any cairo surface whose user space is interface pixels. Returns the plot's place in interface pixels.
ChartLayout paint_chart_on(const Canvas& canvas, const ChartModel& chart, double width, double height, const ChartStyle& style);

Rgba chart_colour(const ChartColour& colour, Theme theme);

}  // namespace stemwise::render
