#include "core/survey/outline_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <queue>

namespace stemwise {
namespace {

constexpr double gap_in_spacings = 5.0;
constexpr double smallest_gap_m = 5.0, largest_gap_m = 20.0;
constexpr int cells_per_gap = 5;
constexpr double most_cells = 4e6;
constexpr double least_share = 0.8;  ///< of the points in the outline's part; else the parts are separate plots

struct Cell {
  int column = 0, row = 0;
  bool operator==(const Cell&) const = default;
};

/// A bitmap over the points' extent with a border that nothing reaches.
struct Raster {
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  double cell_m = 1.0;
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> on;

  bool has(Cell c) const { return c.column >= 0 && c.row >= 0 && c.column < columns && c.row < rows; }
  std::uint8_t& at(Cell c) { return on[static_cast<std::size_t>(c.row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c.column)]; }
  bool is_on(Cell c) const {
    return has(c) && on[static_cast<std::size_t>(c.row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c.column)] != 0;
  }
  Cell cell_of(const Eigen::Vector2d& point_m) const {
    const Eigen::Vector2d at = (point_m - origin_m) / cell_m;
    return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
  }
};

/// Median distance to the nearest neighbour, by a sort along x: close enough to linear for points spread in the plane.
double usual_spacing_m(std::span<const Eigen::Vector2d> points_m) {
  std::vector<Eigen::Vector2d> sorted(points_m.begin(), points_m.end());
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<double> nearest(sorted.size(), 1e9);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].x() - sorted[i].x() < std::min(nearest[i], largest_gap_m); ++j) {
      const double distance = (sorted[j] - sorted[i]).norm();
      if (distance < 0.05) continue;  // stems of one stool say nothing about spacing
      nearest[i] = std::min(nearest[i], distance);
      nearest[j] = std::min(nearest[j], distance);
    }
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

void stamp(Raster& raster, Cell center, double radius_m, std::uint8_t value) {
  const int reach = static_cast<int>(std::ceil(radius_m / raster.cell_m));
  const double limit = radius_m / raster.cell_m * (radius_m / raster.cell_m);
  for (int dr = -reach; dr <= reach; ++dr) {
    for (int dc = -reach; dc <= reach; ++dc) {
      const Cell cell{center.column + dc, center.row + dr};
      if (dr * dr + dc * dc <= limit && raster.has(cell)) raster.at(cell) = value;
    }
  }
}

Raster dilated(std::span<const Eigen::Vector2d> points_m, double gap_m) {
  Eigen::Vector2d low = points_m[0], high = points_m[0];
  for (const Eigen::Vector2d& p : points_m) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Eigen::Vector2d extent = (high - low).array() + 4.0 * gap_m;
  Raster raster;
  raster.cell_m = std::max(gap_m / cells_per_gap, std::sqrt(extent.prod() / most_cells));
  raster.origin_m = low.array() - 2.0 * gap_m;
  raster.columns = static_cast<int>(extent.x() / raster.cell_m) + 1;
  raster.rows = static_cast<int>(extent.y() / raster.cell_m) + 1;
  raster.on.assign(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows), 0);
  for (const Eigen::Vector2d& p : points_m) stamp(raster, raster.cell_of(p), gap_m, 1);
  return raster;
}

constexpr Cell neighbours[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

void erode(Raster& raster, double radius_m) {
  std::vector<Cell> edge;
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      const Cell cell{column, row};
      if (raster.is_on(cell)) continue;
      const bool touches = std::any_of(std::begin(neighbours), std::end(neighbours),
                                       [&](Cell n) { return raster.is_on({column + n.column, row + n.row}); });
      if (touches) edge.push_back(cell);
    }
  }
  for (const Cell cell : edge) stamp(raster, cell, radius_m, 0);
}

/// Labels 4-connected parts from 1 on.
std::vector<int> parts_of(const Raster& raster) {
  std::vector<int> part(raster.on.size(), 0);
  const auto index = [&](Cell c) { return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(raster.columns) + static_cast<std::size_t>(c.column); };
  int parts = 0;
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      if (!raster.is_on({column, row}) || part[index({column, row})] != 0) continue;
      std::queue<Cell> open;
      open.push({column, row});
      part[index({column, row})] = ++parts;
      for (; !open.empty(); open.pop()) {
        for (const Cell n : neighbours) {
          const Cell next{open.front().column + n.column, open.front().row + n.row};
          if (!raster.is_on(next) || part[index(next)] != 0) continue;
          part[index(next)] = parts;
          open.push(next);
        }
      }
    }
  }
  return part;
}

/// Keeps only the part that holds the most points; the share of the points that it holds.
double keep_main_part(Raster& raster, std::span<const Eigen::Vector2d> points_m) {
  const std::vector<int> part = parts_of(raster);
  std::vector<std::size_t> count(static_cast<std::size_t>(part.empty() ? 0 : *std::max_element(part.begin(), part.end())) + 1, 0);
  for (const Eigen::Vector2d& p : points_m) {
    const Cell c = raster.cell_of(p);
    const int label = part[static_cast<std::size_t>(c.row) * static_cast<std::size_t>(raster.columns) + static_cast<std::size_t>(c.column)];
    if (label > 0) ++count[static_cast<std::size_t>(label)];
  }
  const auto main = std::max_element(count.begin(), count.end());
  const int kept = static_cast<int>(main - count.begin());
  for (std::size_t i = 0; i < part.size(); ++i) raster.on[i] = kept > 0 && part[i] == kept ? 1 : 0;
  return static_cast<double>(*main) / static_cast<double>(points_m.size());
}

/// Follows the outer edge of the on cells counter-clockwise, the inside on the left, corner by corner.
std::vector<Eigen::Vector2d> outer_edge(const Raster& raster) {
  const auto first = std::find(raster.on.begin(), raster.on.end(), 1);
  if (first == raster.on.end()) return {};
  const auto at = static_cast<int>(first - raster.on.begin());
  const Cell start{at % raster.columns, at / raster.columns};  // its lower edge is outside: walk along it towards +x
  const auto inside = [&](Cell corner, int side, int direction) {
    // The cells left (side 0) and right (side 1) of the step that leaves `corner` in `direction` (0 +x, 1 +y, 2 -x, 3 -y).
    constexpr Cell left[] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
    constexpr Cell right[] = {{0, -1}, {0, 0}, {-1, 0}, {-1, -1}};
    const Cell offset = side == 0 ? left[direction] : right[direction];
    return raster.is_on({corner.column + offset.column, corner.row + offset.row});
  };
  std::vector<Eigen::Vector2d> corners;
  Cell corner = start;
  int direction = 0;
  do {
    corners.push_back(raster.origin_m + raster.cell_m * Eigen::Vector2d(corner.column, corner.row));
    corner = {corner.column + neighbours[direction].column, corner.row + neighbours[direction].row};
    if (inside(corner, 1, direction)) {
      direction = (direction + 3) % 4;  // outside turned away: right turn
    } else if (!inside(corner, 0, direction)) {
      direction = (direction + 1) % 4;
    }
  } while (!(corner == start && direction == 0));
  return corners;
}

double distance_to_chord(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double t = along.squaredNorm() > 0.0 ? std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

/// Douglas and Peucker (1973) on the closed edge, split at its first corner and the one farthest from it.
void simplify(const std::vector<Eigen::Vector2d>& line, std::size_t from, std::size_t to, double tolerance_m, std::vector<Eigen::Vector2d>& out) {
  std::size_t farthest = from;
  double most = tolerance_m;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double distance = distance_to_chord(line[i], line[from], line[to]);
    if (distance > most) most = distance, farthest = i;
  }
  if (farthest == from) {
    out.push_back(line[from]);
    return;
  }
  simplify(line, from, farthest, tolerance_m, out);
  simplify(line, farthest, to, tolerance_m, out);
}

Polygon simplified(std::vector<Eigen::Vector2d> corners, double tolerance_m) {
  if (corners.size() < 4) return {corners};
  std::size_t far = 1;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if ((corners[i] - corners[0]).norm() > (corners[far] - corners[0]).norm()) far = i;
  }
  corners.push_back(corners[0]);
  Polygon polygon;
  simplify(corners, 0, far, tolerance_m, polygon.corners_m);
  simplify(corners, far, corners.size() - 1, tolerance_m, polygon.corners_m);
  return polygon;
}

}  // namespace

Polygon outline_of(std::span<const Eigen::Vector2d> points_m) {
  const Polygon hull = convex_hull(points_m);
  if (hull.empty() || points_m.size() < 12) return hull;
  const double spacing_m = usual_spacing_m(points_m);
  const double gap_m = std::clamp(gap_in_spacings * spacing_m, smallest_gap_m, largest_gap_m);
  Raster raster = dilated(points_m, gap_m);
  erode(raster, gap_m - std::min(spacing_m / 2.0, gap_m / 2.0));  // half a spacing stays: the stems at the edge have room too
  if (keep_main_part(raster, points_m) < least_share) return hull;
  Polygon outline = simplified(outer_edge(raster), 0.9 * raster.cell_m);
  return outline.empty() ? hull : outline;
}

Coverage outline_coverage(const Inventory& inventory) {
  std::vector<Eigen::Vector2d> points_m;
  points_m.reserve(inventory.stems.size());
  for (const Stem& stem : inventory.stems) points_m.emplace_back(stem.x_m, stem.y_m);
  return {outline_of(points_m), inventory.frames ? CoverageSource::frames : CoverageSource::stems};
}

}  // namespace stemwise
