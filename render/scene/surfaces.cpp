#include "render/scene/surfaces.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace stemwise::render {
namespace {

constexpr double above_ground_m = 0.06;
constexpr double heat_depth_m = -4.0;
constexpr double heat_strength = 0.6;
constexpr double coverage_depth_m = -5.0;  // under everything on the map

bool is_cell_known(const Ground& ground, int column, int row) {
  return ground.is_known[ground.at(column, row)] && ground.is_known[ground.at(column + 1, row)] && ground.is_known[ground.at(column, row + 1)] &&
         ground.is_known[ground.at(column + 1, row + 1)];
}

}  // namespace

vtkSmartPointer<vtkPolyData> surface_of(const Ground& ground) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int row = 0; row < ground.rows; ++row)
    for (int column = 0; column < ground.columns; ++column) points->InsertNextPoint(ground.node_m(column, row).data());
  for (int row = 0; row + 1 < ground.rows; ++row)
    for (int column = 0; column + 1 < ground.columns; ++column) {
      if (!is_cell_known(ground, column, row)) continue;
      const auto id = [&ground](int c, int r) { return static_cast<vtkIdType>(ground.at(c, r)); };
      const vtkIdType low[3] = {id(column, row), id(column + 1, row), id(column + 1, row + 1)};
      const vtkIdType high[3] = {id(column, row), id(column + 1, row + 1), id(column, row + 1)};
      cells->InsertNextCell(3, low);
      cells->InsertNextCell(3, high);
    }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> surface_of(const CoverageShape& coverage) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(coverage.corners_m.size()));
  for (const Eigen::Vector2d& corner : coverage.corners_m)
    cells->InsertCellPoint(points->InsertNextPoint(corner.x(), corner.y(), coverage_depth_m));
  vtkNew<vtkPolyData> outline;
  outline->SetPoints(points);
  outline->SetPolys(cells);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(outline);
  triangles->Update();
  return triangles->GetOutput();
}

vtkSmartPointer<vtkPolyData> surface_of(const HeatGrid& heat, Theme theme) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  const Rgba paper = theme_colours(theme).map;
  for (int row = 0; row < heat.rows; ++row)
    for (int column = 0; column < heat.columns; ++column) {
      points->InsertNextPoint(heat.low_m.x() + column * heat.step_m, heat.low_m.y() + row * heat.step_m, heat_depth_m);
      const Rgba c = mix(paper, cividis((heat.value[heat.at(column, row)] - heat.low) / (heat.high - heat.low)), heat_strength);
      const unsigned char components[3] = {c.r, c.g, c.b};
      colours->InsertNextTypedTuple(components);
    }
  for (int row = 0; row + 1 < heat.rows; ++row)
    for (int column = 0; column + 1 < heat.columns; ++column) {
      const vtkIdType corners[4] = {static_cast<vtkIdType>(heat.at(column, row)), static_cast<vtkIdType>(heat.at(column + 1, row)),
                                    static_cast<vtkIdType>(heat.at(column + 1, row + 1)), static_cast<vtkIdType>(heat.at(column, row + 1))};
      bool is_known = true;
      for (const vtkIdType corner : corners) is_known &= heat.is_known[static_cast<std::size_t>(corner)] != 0;
      if (is_known) cells->InsertNextCell(4, corners);
    }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->SetScalars(colours);
  return surface;
}

std::vector<LineSegment> residual_arrows(const SceneModel& scene, Theme theme) {
  const Rgba colour = theme_colours(theme).warning;
  std::vector<LineSegment> segments;
  segments.reserve(3 * scene.links.size());
  for (const Link& link : scene.links) {
    const Eigen::Vector3d along(scene.residual_factor * (link.b_m.x() - link.a_m.x()), scene.residual_factor * (link.b_m.y() - link.a_m.y()), 0.0);
    const Eigen::Vector3d tip = link.a_m + along, across(-along.y(), along.x(), 0.0);
    segments.push_back({link.a_m, tip, colour, 1.3});
    segments.push_back({tip, tip - 0.22 * along + 0.13 * across, colour, 1.3});
    segments.push_back({tip, tip - 0.22 * along - 0.13 * across, colour, 1.3});
  }
  return segments;
}

std::vector<LineSegment> coverage_outlines(const SceneModel& scene) {
  std::vector<LineSegment> segments;
  for (const CoverageShape& shape : scene.coverages) {
    double along_m = 0.0;
    for (std::size_t i = 0; i < shape.corners_m.size(); ++i) {
      const Eigen::Vector2d& a = shape.corners_m[i];
      const Eigen::Vector2d& b = shape.corners_m[(i + 1) % shape.corners_m.size()];
      segments.push_back({{a.x(), a.y(), 0.0}, {b.x(), b.y(), 0.0}, shape.outline.with_alpha(0.65), 1.2, 6.0, along_m});
      along_m += (b - a).norm();
    }
  }
  return segments;
}

std::vector<LineSegment> link_lines(const SceneModel& scene, Theme theme, bool is_map) {
  const Rgba colour = is_map ? theme_colours(theme).text.with_alpha(0.6) : theme_colours(theme).secondary.with_alpha(0.7);
  std::vector<LineSegment> segments;
  segments.reserve(scene.links.size());
  const Eigen::Vector3d lift = is_map ? Eigen::Vector3d::Zero() : Eigen::Vector3d(0.0, 0.0, 1.3);
  for (const Link& link : scene.links) segments.push_back({link.a_m + lift, link.b_m + lift, colour, 1.1});
  return segments;
}

std::vector<LineSegment> grid_lines(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m, const Eigen::Vector2d& phase_m, double step_m, Rgba colour) {
  std::vector<LineSegment> segments;
  const auto first = [step_m](double low, double phase) { return std::ceil((low + phase) / step_m) * step_m - phase; };
  for (double x = first(low_m.x(), phase_m.x()); x <= high_m.x(); x += step_m) segments.push_back({{x, low_m.y(), 0.0}, {x, high_m.y(), 0.0}, colour, 1.0});
  for (double y = first(low_m.y(), phase_m.y()); y <= high_m.y(); y += step_m) segments.push_back({{low_m.x(), y, 0.0}, {high_m.x(), y, 0.0}, colour, 1.0});
  return segments;
}

std::vector<LineSegment> ground_lines(const Ground& ground, Rgba colour) {
  std::vector<LineSegment> segments;
  const int every = std::max(1, std::max(ground.columns, ground.rows) / 24);
  const Eigen::Vector3d lift(0.0, 0.0, above_ground_m);
  const auto add = [&](int c0, int r0, int c1, int r1) {
    if (ground.is_known[ground.at(c0, r0)] && ground.is_known[ground.at(c1, r1)])
      segments.push_back({ground.node_m(c0, r0) + lift, ground.node_m(c1, r1) + lift, colour, 1.0});
  };
  for (int row = 0; row < ground.rows; ++row)
    for (int column = 0; column < ground.columns; ++column) {
      if (row % every == 0 && column + 1 < ground.columns) add(column, row, column + 1, row);
      if (column % every == 0 && row + 1 < ground.rows) add(column, row, column, row + 1);
    }
  return segments;
}

}  // namespace stemwise::render
