#include "core/underlay/arrange_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/random.hpp"

namespace stemwise {
namespace {

constexpr double ground_cell_m = 2.0;
constexpr double most_slope = 0.6;
constexpr double low_share = 0.03;
constexpr int slope_passes = 3;
constexpr int most_cells_per_side = 600;
constexpr int tiles_per_side = 24;
constexpr double least_tile_m = 4.0;

struct Box {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
};

Box box_of(const std::vector<RawPoint>& points) {
  Box box;
  for (const RawPoint& p : points) {
    box.low = box.low.cwiseMin(p.position);
    box.high = box.high.cwiseMax(p.position);
  }
  return box;
}

/// Squares over the cloud; nodes of the ground lie in their middles.
struct Squares {
  Eigen::Vector2d low_m;
  double edge_m;
  int columns, rows;

  Squares(const Box& box, double least_edge_m, int most_per_side) : low_m(box.low.head<2>()) {
    const Eigen::Vector2d extent = (box.high - box.low).head<2>();
    edge_m = std::max(least_edge_m, extent.maxCoeff() / most_per_side);
    columns = static_cast<int>(extent.x() / edge_m) + 1;
    rows = static_cast<int>(extent.y() / edge_m) + 1;
  }
  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t at(int column, int row) const { return static_cast<std::size_t>(row) * columns + column; }
  std::size_t of(const Eigen::Vector3d& p) const {
    const int column = std::clamp(static_cast<int>((p.x() - low_m.x()) / edge_m), 0, columns - 1);
    const int row = std::clamp(static_cast<int>((p.y() - low_m.y()) / edge_m), 0, rows - 1);
    return at(column, row);
  }
};

/// Indices of the points, square by square: `first[i]` to `first[i + 1]` are those of square i.
struct Sorted {
  std::vector<std::size_t> first, index;
};

template <class Test>
Sorted sort_into(const Squares& squares, const std::vector<RawPoint>& points, const Test& is_wanted) {
  Sorted sorted;
  sorted.first.assign(squares.size() + 1, 0);
  for (const RawPoint& p : points) sorted.first[squares.of(p.position) + 1] += is_wanted(p);
  for (std::size_t i = 1; i < sorted.first.size(); ++i) sorted.first[i] += sorted.first[i - 1];
  std::vector<std::size_t> next(sorted.first.begin(), sorted.first.end() - 1);
  sorted.index.resize(sorted.first.back());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_wanted(points[i])) sorted.index[next[squares.of(points[i].position)]++] = i;
  return sorted;
}

/// Heights of the ground in the middles of squares; everywhere, also where no point is.
class GroundNet {
 public:
  GroundNet(const std::vector<RawPoint>& points, const Box& box) : squares_(box, ground_cell_m, most_cells_per_side), height_m_(squares_.size(), unknown) {
    const bool has_class = std::any_of(points.begin(), points.end(), [](const RawPoint& p) { return p.is_ground; });
    Sorted sorted = sort_into(squares_, points, [has_class](const RawPoint& p) { return !has_class || p.is_ground; });
    std::vector<double> heights;
    for (std::size_t i = 0; i < squares_.size(); ++i) {
      heights.clear();
      for (std::size_t k = sorted.first[i]; k < sorted.first[i + 1]; ++k) heights.push_back(points[sorted.index[k]].position.z());
      if (heights.empty()) continue;
      const auto low = heights.begin() + static_cast<std::ptrdiff_t>(low_share * static_cast<double>(heights.size()));
      std::nth_element(heights.begin(), low, heights.end());
      height_m_[i] = *low;
    }
    fill();
    for (int pass = 0; pass < slope_passes; ++pass) flatten();
  }

  /// Bilinear between the middles.
  double height_at_m(const Eigen::Vector3d& p) const {
    const double x = std::clamp((p.x() - squares_.low_m.x()) / squares_.edge_m - 0.5, 0.0, squares_.columns - 1.0);
    const double y = std::clamp((p.y() - squares_.low_m.y()) / squares_.edge_m - 0.5, 0.0, squares_.rows - 1.0);
    const int c = std::min(static_cast<int>(x), std::max(0, squares_.columns - 2)), r = std::min(static_cast<int>(y), std::max(0, squares_.rows - 2));
    const int c1 = std::min(c + 1, squares_.columns - 1), r1 = std::min(r + 1, squares_.rows - 1);
    const double u = x - c, v = y - r;
    return (1 - v) * ((1 - u) * height_m_[squares_.at(c, r)] + u * height_m_[squares_.at(c1, r)]) +
           v * ((1 - u) * height_m_[squares_.at(c, r1)] + u * height_m_[squares_.at(c1, r1)]);
  }

 private:
  static constexpr double unknown = std::numeric_limits<double>::infinity();

  /// Calls `with` for each of the up to eight known neighbours: height and distance.
  template <class With>
  void around(int column, int row, const std::vector<double>& heights, const With& with) const {
    for (int r = std::max(0, row - 1); r <= std::min(squares_.rows - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(squares_.columns - 1, column + 1); ++c) {
        const double height = heights[squares_.at(c, r)];
        if ((c != column || r != row) && height != unknown) with(height, squares_.edge_m * std::hypot(c - column, r - row));
      }
  }

  /// Unknown squares take the mean of their known neighbours, ring by ring around what is known.
  void fill() {
    std::vector<std::size_t> ring;
    for (std::size_t i = 0; i < height_m_.size(); ++i)
      if (height_m_[i] != unknown) ring.push_back(i);
    std::vector<std::uint8_t> is_met(height_m_.size(), 0);
    while (!ring.empty()) {
      const std::vector<std::size_t> next = unknown_around(ring, is_met);
      std::vector<double> means;
      for (const std::size_t i : next) {
        double sum = 0.0;
        int count = 0;
        around(static_cast<int>(i % squares_.columns), static_cast<int>(i / squares_.columns), height_m_, [&](double height, double) { sum += height, ++count; });
        means.push_back(sum / count);
      }
      for (std::size_t k = 0; k < next.size(); ++k) height_m_[next[k]] = means[k];
      ring = next;
    }
  }

  /// Each once over all calls.
  std::vector<std::size_t> unknown_around(const std::vector<std::size_t>& ring, std::vector<std::uint8_t>& is_met) const {
    std::vector<std::size_t> found;
    for (const std::size_t i : ring) {
      const int column = static_cast<int>(i % squares_.columns), row = static_cast<int>(i / squares_.columns);
      for (int r = std::max(0, row - 1); r <= std::min(squares_.rows - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(squares_.columns - 1, column + 1); ++c) {
          const std::size_t k = squares_.at(c, r);
          if (height_m_[k] == unknown && !std::exchange(is_met[k], std::uint8_t{1})) found.push_back(k);
        }
    }
    return found;
  }

  /// What stands out above its neighbours is no ground.
  void flatten() {
    const std::vector<double> before = height_m_;
    for (int row = 0; row < squares_.rows; ++row)
      for (int column = 0; column < squares_.columns; ++column) {
        double& height_m = height_m_[squares_.at(column, row)];
        around(column, row, before, [&](double height, double distance_m) { height_m = std::min(height_m, height + most_slope * distance_m); });
      }
  }

  Squares squares_;
  std::vector<double> height_m_;
};

/// Between which intensities grey is spread.
std::pair<double, double> stretch_of(const std::vector<RawPoint>& points) {
  std::vector<std::uint16_t> values;
  values.reserve(points.size());
  for (const RawPoint& p : points) values.push_back(p.intensity);
  const auto at = [&](double share) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return static_cast<double>(*place);
  };
  const double low = at(0.02), high = at(0.98);
  return {low, std::max(high, low + 1.0)};
}

CloudPoint point_of(const RawPoint& raw, const Eigen::Vector3d& origin_m, const GroundNet& ground, const std::pair<double, double>& stretch) {
  const Eigen::Vector3f p = (raw.position - origin_m).cast<float>();
  const double grey = 255.0 * (raw.intensity - stretch.first) / (stretch.second - stretch.first);
  return {p.x(), p.y(), p.z(), static_cast<float>(raw.position.z() - ground.height_at_m(raw.position)),
          raw.red, raw.green, raw.blue, static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0))};
}

}  // namespace

CloudUnderlay arrange_cloud(std::vector<RawPoint> points, double spacing_m) {
  CloudUnderlay cloud{.spacing_m = spacing_m};
  if (points.empty()) return cloud;
  const Box box = box_of(points);
  cloud.origin_in_reference_m = (0.5 * (box.low + box.high)).array().round();
  const GroundNet ground(points, box);
  const auto stretch = stretch_of(points);
  for (const RawPoint& p : points) {
    cloud.has_intensity |= p.intensity != points.front().intensity;
    cloud.has_colour |= (p.red | p.green | p.blue) != 0;
  }
  const Squares squares(box, least_tile_m, tiles_per_side);
  Sorted sorted = sort_into(squares, points, [](const RawPoint&) { return true; });
  cloud.tile_m = squares.edge_m;
  cloud.points.reserve(points.size());
  Random random(1);
  for (std::size_t tile = 0; tile < squares.size(); ++tile) {
    const std::size_t first = sorted.first[tile], count = sorted.first[tile + 1] - first;
    if (count == 0) continue;
    cloud.tiles.push_back({first, count});
    for (std::size_t k = count; k > 1; --k) std::swap(sorted.index[first + k - 1], sorted.index[first + random.below(k)]);
    for (std::size_t k = 0; k < count; ++k) cloud.points.push_back(point_of(points[sorted.index[first + k]], cloud.origin_in_reference_m, ground, stretch));
  }
  return cloud;
}

}  // namespace stemwise
