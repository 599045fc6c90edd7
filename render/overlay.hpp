#pragma once
#include "render/paint/canvas.hpp"
#include "render/projection.hpp"
#include "render/scene_model.hpp"

namespace stemwise::render {

/// Everything crisp that lies over the scene: selection, labels, captions, legend, scale bar, north arrow, title. `canvas`
/// is an empty picture of the projection's size and scale.
void paint_overlay(const Canvas& canvas, const SceneModel& scene, const Projection& projection, const ViewOptions& options);

/// The length of the scale bar: 1, 2 or 5 times a power of ten, at most `most_px` pixels long.
double scale_bar_m(double metres_per_px, double most_px);
/// "20 m", "0.5 m", "1 km".
std::string length_text(double length_m);

}  // namespace stemwise::render
