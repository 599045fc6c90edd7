#include "core/geometry/raster_mask.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stemwise {
namespace {

constexpr double most_cells = 4e6;
constexpr double far_away = 1e18;

using Ring = std::vector<Eigen::Vector2d>;

/// Lower envelope of parabolas: exact squared distances along one line (Felzenszwalb and Huttenlocher 2012).
void transform_line(std::vector<double>& f, std::vector<double>& scratch, std::vector<int>& hull, std::vector<double>& border) {
  const int n = static_cast<int>(f.size());
  int k = 0;
  hull[0] = 0;
  border[0] = -std::numeric_limits<double>::infinity();
  border[1] = std::numeric_limits<double>::infinity();
  const auto meet = [&](int q, int p) { return ((f[q] + double(q) * q) - (f[p] + double(p) * p)) / (2.0 * q - 2.0 * p); };
  for (int q = 1; q < n; ++q) {
    double s = meet(q, hull[k]);
    while (k > 0 && s <= border[k]) s = meet(q, hull[--k]);
    if (s > border[k]) ++k;
    hull[k] = q;
    border[k] = s;
    border[k + 1] = std::numeric_limits<double>::infinity();
  }
  k = 0;
  for (int q = 0; q < n; ++q) {
    while (border[k + 1] < q) ++k;
    scratch[q] = double(q - hull[k]) * (q - hull[k]) + f[hull[k]];
  }
  std::copy(scratch.begin(), scratch.begin() + n, f.begin());
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double signed_area_sq_m(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return twice / 2.0;
}

double distance_to_line_m(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double t = along.squaredNorm() > 0.0 ? std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

/// Douglas-Peucker between two kept corners; marks what stays.
void keep_corners(const Ring& ring, std::size_t first, std::size_t last, double tolerance_m, std::vector<char>& keep) {
  std::size_t farthest = first;
  double most = tolerance_m;
  for (std::size_t i = first + 1; i < last; ++i)
    if (const double d = distance_to_line_m(ring[i], ring[first], ring[last % ring.size()]); d > most) most = d, farthest = i;
  if (farthest == first) return;
  keep[farthest] = 1;
  keep_corners(ring, first, farthest, tolerance_m, keep);
  keep_corners(ring, farthest, last, tolerance_m, keep);
}

Ring simplified(const Ring& ring, double tolerance_m) {
  if (ring.size() < 5) return ring;
  std::size_t opposite = 0;
  for (std::size_t i = 1; i < ring.size(); ++i)
    if ((ring[i] - ring[0]).squaredNorm() > (ring[opposite] - ring[0]).squaredNorm()) opposite = i;
  std::vector<char> keep(ring.size(), 0);
  keep[0] = keep[opposite] = 1;
  keep_corners(ring, 0, opposite, tolerance_m, keep);
  keep_corners(ring, opposite, ring.size(), tolerance_m, keep);
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (keep[i] != 0) result.push_back(ring[i]);
  return result;
}

/// The middles of the edges of a ring of cell borders: its corners cut.
Ring corners_cut(const Ring& ring) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) result.push_back(0.5 * (ring[i] + ring[(i + 1) % ring.size()]));
  return result;
}

bool segments_cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
}

bool crosses(const Ring& ring, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (segments_cross(ring[i], ring[(i + 1) % ring.size()], a, b)) return true;
  return false;
}

struct Slit {
  std::size_t outer = 0, hole = 0;
  double length_sq = std::numeric_limits<double>::infinity();
};

/// The shortest connection of two corners that crosses no edge.
Slit shortest_slit(const Ring& outer, const Ring& hole, const std::vector<Ring>& others) {
  std::vector<Slit> slits;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    Slit nearest;
    for (std::size_t j = 0; j < hole.size(); ++j)
      if (const double d = (outer[i] - hole[j]).squaredNorm(); d < nearest.length_sq) nearest = {i, j, d};
    slits.push_back(nearest);
  }
  std::sort(slits.begin(), slits.end(), [](const Slit& a, const Slit& b) { return a.length_sq != b.length_sq ? a.length_sq < b.length_sq : a.outer < b.outer; });
  for (const Slit& slit : slits) {
    const Eigen::Vector2d &a = outer[slit.outer], &b = hole[slit.hole];
    if (crosses(outer, a, b) || crosses(hole, a, b)) continue;
    if (std::none_of(others.begin(), others.end(), [&](const Ring& other) { return crosses(other, a, b); })) return slit;
  }
  return slits.front();
}

/// A point of the ring half a centimetre before (-1) or after (+1) corner i, so that the two sides of a slit do not touch.
Eigen::Vector2d beside(const Ring& ring, std::size_t i, int side) {
  constexpr double half_slit_m = 0.005;
  const Eigen::Vector2d& next = ring[side > 0 ? (i + 1) % ring.size() : (i + ring.size() - 1) % ring.size()];
  const double length = (next - ring[i]).norm();
  return ring[i] + (next - ring[i]) * std::min(0.25, half_slit_m / std::max(length, 1e-9));
}

/// The outer ring goes round left, the hole right; joined by a slit they are one ring.
Ring joined(const Ring& outer, const Ring& hole, const Slit& slit) {
  Ring result(outer.begin(), outer.begin() + static_cast<std::ptrdiff_t>(slit.outer));
  result.push_back(beside(outer, slit.outer, -1));
  result.push_back(beside(hole, slit.hole, +1));
  for (std::size_t k = 1; k < hole.size(); ++k) result.push_back(hole[(slit.hole + k) % hole.size()]);
  result.push_back(beside(hole, slit.hole, -1));
  result.push_back(beside(outer, slit.outer, +1));
  result.insert(result.end(), outer.begin() + static_cast<std::ptrdiff_t>(slit.outer) + 1, outer.end());
  return result;
}

}  // namespace

RasterMask::RasterMask(std::span<const Eigen::Vector2d> points, double margin_m, double cell_m) {
  if (points.empty()) return;
  Eigen::Vector2d high = low_ = points[0];
  for (const auto& p : points) low_ = low_.cwiseMin(p), high = high.cwiseMax(p);
  const Eigen::Vector2d size = (high - low_).array() + 2.0 * margin_m;
  cell_m_ = std::max({cell_m, 1e-3, std::sqrt(size.x() * size.y() / most_cells)});
  low_ -= Eigen::Vector2d::Constant(margin_m + 2.0 * cell_m_);
  columns_ = static_cast<int>(size.x() / cell_m_) + 5;
  rows_ = static_cast<int>(size.y() / cell_m_) + 5;
  cells_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
}

RasterMask RasterMask::blank() const {
  RasterMask mask;
  mask.low_ = low_;
  mask.cell_m_ = cell_m_;
  mask.columns_ = columns_;
  mask.rows_ = rows_;
  mask.cells_.assign(cells_.size(), 0);
  return mask;
}

void RasterMask::set(const Eigen::Vector2d& point) {
  const int x = static_cast<int>(std::floor((point.x() - low_.x()) / cell_m_)), y = static_cast<int>(std::floor((point.y() - low_.y()) / cell_m_));
  if (x >= 0 && y >= 0 && x < columns_ && y < rows_) cells_[place(x, y)] = 1;
}

bool RasterMask::at(const Eigen::Vector2d& point) const {
  return cell(static_cast<int>(std::floor((point.x() - low_.x()) / cell_m_)), static_cast<int>(std::floor((point.y() - low_.y()) / cell_m_)));
}

std::size_t RasterMask::count() const { return static_cast<std::size_t>(std::count(cells_.begin(), cells_.end(), std::uint8_t{1})); }

std::vector<double> RasterMask::distance_sq_to(bool inside) const {
  std::vector<double> grid(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) grid[i] = (cells_[i] != 0) == inside ? 0.0 : far_away;
  const auto longest = static_cast<std::size_t>(std::max(columns_, rows_));
  std::vector<double> line, scratch(longest), border(longest + 1);
  std::vector<int> hull(longest + 1);
  line.resize(static_cast<std::size_t>(rows_));
  for (int x = 0; x < columns_; ++x) {
    for (int y = 0; y < rows_; ++y) line[static_cast<std::size_t>(y)] = grid[place(x, y)];
    transform_line(line, scratch, hull, border);
    for (int y = 0; y < rows_; ++y) grid[place(x, y)] = line[static_cast<std::size_t>(y)];
  }
  line.resize(static_cast<std::size_t>(columns_));
  for (int y = 0; y < rows_; ++y) {
    std::copy_n(grid.begin() + static_cast<std::ptrdiff_t>(place(0, y)), columns_, line.begin());
    transform_line(line, scratch, hull, border);
    std::copy_n(line.begin(), columns_, grid.begin() + static_cast<std::ptrdiff_t>(place(0, y)));
  }
  return grid;
}

RasterMask RasterMask::dilated(double radius_m) const {
  RasterMask result = blank();
  const std::vector<double> distance_sq = distance_sq_to(true);
  const double limit_sq = radius_m * radius_m / (cell_m_ * cell_m_);
  for (std::size_t i = 0; i < cells_.size(); ++i) result.cells_[i] = distance_sq[i] <= limit_sq ? 1 : 0;
  return result;
}

RasterMask RasterMask::eroded(double radius_m) const {
  RasterMask result = blank();
  const std::vector<double> distance_sq = distance_sq_to(false);
  const double limit_sq = radius_m * radius_m / (cell_m_ * cell_m_);
  for (std::size_t i = 0; i < cells_.size(); ++i) result.cells_[i] = cells_[i] != 0 && distance_sq[i] > limit_sq ? 1 : 0;
  return result;
}

std::vector<std::vector<std::size_t>> RasterMask::connected(bool inside) const {
  std::vector<std::vector<std::size_t>> found;
  std::vector<std::uint8_t> left(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) left[i] = (cells_[i] != 0) == inside ? 1 : 0;
  const auto columns = static_cast<std::size_t>(columns_);
  for (std::size_t start = 0; start < left.size(); ++start) {
    if (left[start] == 0) continue;
    std::vector<std::size_t>& part = found.emplace_back(1, start);
    left[start] = 0;
    for (std::size_t done = 0; done < part.size(); ++done) {
      const std::size_t c = part[done], x = c % columns;
      const auto take = [&](std::size_t n) {
        if (left[n] != 0) left[n] = 0, part.push_back(n);
      };
      if (x > 0) take(c - 1);
      if (x + 1 < columns) take(c + 1);
      if (c >= columns) take(c - columns);
      if (c + columns < left.size()) take(c + columns);
    }
  }
  return found;
}

std::size_t RasterMask::part_count() const { return connected(true).size(); }

RasterMask RasterMask::largest_part() const {
  const auto parts = connected(true);
  RasterMask result = blank();
  const auto largest = std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  if (largest != parts.end())
    for (const std::size_t c : *largest) result.cells_[c] = 1;
  return result;
}

RasterMask RasterMask::without_holes(double area_sq_m) const {
  RasterMask result = *this;
  for (const std::vector<std::size_t>& part : connected(false)) {
    const bool border = part.front() == 0;  // the first cell is in the margin
    if (border || static_cast<double>(part.size()) * cell_m_ * cell_m_ >= area_sq_m) continue;
    for (const std::size_t c : part) result.cells_[c] = 1;
  }
  return result;
}

/// Cell borders walked with the inside on the left; where two cells touch at a corner only, the walk turns left and keeps them apart.
std::vector<std::vector<Eigen::Vector2d>> RasterMask::rings() const {
  constexpr std::array<std::array<int, 2>, 4> step{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  // a border edge starts at a lattice corner and goes in direction d; left of it is inside, right of it outside
  const auto left_of = [&](int x, int y, std::size_t d) { return d == 0 ? cell(x, y) : d == 1 ? cell(x - 1, y) : d == 2 ? cell(x - 1, y - 1) : cell(x, y - 1); };
  const auto right_of = [&](int x, int y, std::size_t d) { return d == 0 ? cell(x, y - 1) : d == 1 ? cell(x, y) : d == 2 ? cell(x - 1, y) : cell(x - 1, y - 1); };
  const auto is_edge = [&](int x, int y, std::size_t d) { return left_of(x, y, d) && !right_of(x, y, d); };
  std::vector<char> walked(4 * static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1), 0);
  const auto edge_place = [&](int x, int y, std::size_t d) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_ + 1) + static_cast<std::size_t>(x)) + d;
  };
  std::vector<Ring> found;
  for (int y = 0; y <= rows_; ++y)
    for (int x = 0; x <= columns_; ++x) {
      if (!is_edge(x, y, 0) || walked[edge_place(x, y, 0)] != 0) continue;
      Ring ring;
      int u = x, v = y;
      std::size_t d = 0;
      while (walked[edge_place(u, v, d)] == 0) {
        walked[edge_place(u, v, d)] = 1;
        ring.push_back(low_ + cell_m_ * Eigen::Vector2d(u, v));
        u += step[d][0];
        v += step[d][1];
        for (const std::size_t turn : {1u, 0u, 3u})
          if (is_edge(u, v, (d + turn) % 4)) {
            d = (d + turn) % 4;
            break;
          }
      }
      found.push_back(std::move(ring));
    }
  return found;
}

Polygon RasterMask::outline() const {
  std::vector<Ring> holes;
  Ring outer;
  for (const Ring& ring : rings()) {
    Ring smooth = simplified(corners_cut(ring), 0.45 * cell_m_);
    if (smooth.size() < 3) continue;
    const double area = signed_area_sq_m(smooth);
    if (area < 0.0)
      holes.push_back(std::move(smooth));
    else if (outer.empty() || area > signed_area_sq_m(outer))
      outer = std::move(smooth);
  }
  if (outer.empty()) return {};
  while (!holes.empty()) {  // the nearest hole first: a slit never has to pass another
    std::size_t nearest = 0;
    Slit best;
    for (std::size_t h = 0; h < holes.size(); ++h)
      if (const Slit slit = shortest_slit(outer, holes[h], holes); slit.length_sq < best.length_sq) best = slit, nearest = h;
    outer = joined(outer, holes[nearest], best);
    holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(nearest));
  }
  return {outer};
}

}  // namespace stemwise
