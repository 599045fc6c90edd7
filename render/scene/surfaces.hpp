#pragma once
#include <vtkSmartPointer.h>

#include <vector>

#include "render/ground.hpp"
#include "render/heat_map.hpp"
#include "render/scene/line_layer.hpp"
#include "render/scene_model.hpp"

class vtkPolyData;

namespace stemwise::render {

vtkSmartPointer<vtkPolyData> surface_of(const Ground& ground);
vtkSmartPointer<vtkPolyData> surface_of(const CoverageShape& coverage);

/// With its colours at the points, mixed into the theme's map.
vtkSmartPointer<vtkPolyData> surface_of(const HeatGrid& heat, Theme theme);

std::vector<LineSegment> coverage_outlines(const SceneModel& scene);
/// Arrows from the earlier to the later sighting, lengthened by the scene's factor.
std::vector<LineSegment> residual_arrows(const SceneModel& scene, Theme theme);
std::vector<LineSegment> link_lines(const SceneModel& scene, Theme theme, bool is_map);
/// Lines every `step_m` of world coordinates that fill the given box.
std::vector<LineSegment> grid_lines(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m, const Eigen::Vector2d& phase_m, double step_m, Rgba colour);
/// The ground's own grid, thinned out.
std::vector<LineSegment> ground_lines(const Ground& ground, Rgba colour);

}  // namespace stemwise::render
