#include "render/scene/surfaces.hpp"

#include "render/cut_grid.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <map>
#include <cmath>

namespace stemwise::render {
namespace {

constexpr double above_ground_m = 0.06;
constexpr double heat_depth_m = -4.0;
constexpr double coverage_depth_m = -5.0;  // under everything on the map

double heat_strength(Theme theme) { return theme == Theme::dark ? 0.5 : 0.6; }

/// The points of a cut grid: its nodes come first, in their order; a point on a cut side is made once.
class CutPoints {
 public:
  /// `make` adds the point of a corner on a cut side and returns its number.
  template <class Make>
  vtkIdType id_of(const CutCorner& corner, Make make) {
    if (corner.is_node()) return static_cast<vtkIdType>(corner.from);
    const auto [low, high] = std::minmax(corner.from, corner.to);
    const auto [found, is_new] = made_.try_emplace({low, high}, 0);
    if (is_new) found->second = make(corner);
    return found->second;
  }

 private:
  std::map<std::pair<std::size_t, std::size_t>, vtkIdType> made_;
};

/// Triangles around the first corner.
void add_fan(vtkCellArray* cells, const std::vector<vtkIdType>& corners) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const vtkIdType triangle[3] = {corners[0], corners[i], corners[i + 1]};
    cells->InsertNextCell(3, triangle);
  }
}

}  // namespace

vtkSmartPointer<vtkPolyData> surface_of(const Ground& ground) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int row = 0; row < ground.rows; ++row)
    for (int column = 0; column < ground.columns; ++column) points->InsertNextPoint(ground.node_m(column, row).data());
  const auto node_m = [&ground](std::size_t i) { return ground.node_m(static_cast<int>(i) % ground.columns, static_cast<int>(i) / ground.columns); };
  const auto add_point = [&](const CutCorner& c) {
    const Eigen::Vector3d at_m = node_m(c.from) + c.share * (node_m(c.to) - node_m(c.from));
    return points->InsertNextPoint(at_m.data());
  };
  CutPoints made;
  for (const auto& piece : cut_cells(ground.columns, ground.rows, ground.inside)) {
    std::vector<vtkIdType> ids;
    for (const CutCorner& corner : piece) ids.push_back(made.id_of(corner, add_point));
    add_fan(cells, ids);
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
  const auto add_point = [&](const CutCorner& c) {
    const auto place = [&heat](std::size_t i) { return Eigen::Vector2d(static_cast<int>(i) % heat.columns, static_cast<int>(i) / heat.columns); };
    const Eigen::Vector2d at_m = heat.low_m + heat.step_m * (place(c.from) + c.share * (place(c.to) - place(c.from)));
    const double value = heat.value[c.from] + c.share * (heat.value[c.to] - heat.value[c.from]);
    const Rgba colour = mix(paper, cividis((value - heat.low) / (heat.high - heat.low)), heat_strength(theme));
    const unsigned char components[3] = {colour.r, colour.g, colour.b};
    colours->InsertNextTypedTuple(components);
    return points->InsertNextPoint(at_m.x(), at_m.y(), heat_depth_m);
  };
  for (std::size_t i = 0; i < heat.value.size(); ++i) add_point({i, i, 0.0});
  CutPoints made;
  for (const auto& piece : cut_cells(heat.columns, heat.rows, heat.inside)) {
    std::vector<vtkIdType> ids;
    for (const CutCorner& corner : piece) ids.push_back(made.id_of(corner, add_point));
    add_fan(cells, ids);
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
      segments.push_back({{a.x(), a.y(), 0.0}, {b.x(), b.y(), 0.0}, shape.outline.with_alpha(0.5), 1.2, 6.0, along_m});
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
    const auto [first, last] = inner_shares(ground.inside[ground.at(c0, r0)], ground.inside[ground.at(c1, r1)]);
    if (last <= first) return;
    const Eigen::Vector3d a = ground.node_m(c0, r0) + lift, b = ground.node_m(c1, r1) + lift;
    segments.push_back({a + first * (b - a), a + last * (b - a), colour, 1.0});
  };
  for (int row = 0; row < ground.rows; ++row)
    for (int column = 0; column < ground.columns; ++column) {
      if (row % every == 0 && column + 1 < ground.columns) add(column, row, column + 1, row);
      if (column % every == 0 && row + 1 < ground.rows) add(column, row, column, row + 1);
    }
  return segments;
}

}  // namespace stemwise::render
