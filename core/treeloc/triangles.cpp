#include "core/treeloc/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stemwise::treeloc {
namespace {

constexpr std::size_t most_trees = Scene::most_trees;

/// To the nearest whole number; for |v| < 32000 (std::lround is a call, and there are three per triangle).
int rounded(float v) { return static_cast<int>(v + 32768.5F) - 32768; }

/// Angle of (x, y) in 256ths of a turn, rounded. The polynomial is within 0.1 degrees; a step is 1.4.
std::uint8_t turn_of(float x, float y) {
  const float ax = std::abs(x), ay = std::abs(y);
  const float ratio = std::min(ax, ay) / std::max(std::max(ax, ay), 1e-9F);
  const float sq = ratio * ratio;
  float angle = ((-0.0464964749F * sq + 0.15931422F) * sq - 0.327622764F) * sq * ratio + ratio;
  if (ay > ax) angle = std::numbers::pi_v<float> / 2 - angle;
  if (x < 0.0F) angle = std::numbers::pi_v<float> - angle;
  if (y < 0.0F) angle = -angle;
  return static_cast<std::uint8_t>(rounded(angle * (128.0F / std::numbers::pi_v<float>)) & 255);
}

std::int16_t centimetres(float metres) {
  return static_cast<std::int16_t>(rounded(std::clamp(metres * 100.0F, -32000.0F, 32000.0F)));
}

}  // namespace

Fields TriangleSettings::fields(const std::string& prefix) {
  return {{prefix + ".neighbours", "", "Nearest neighbours that a tree makes triangles with", &neighbours},
          {prefix + ".min_side_m", "m", "Shorter sides make no triangle", &min_side_m},
          {prefix + ".max_side_m", "m", "Longer sides make no triangle", &max_side_m},
          {prefix + ".step_m", "m", "Quantisation of sides and area", &step_m},
          {prefix + ".area", "", "The published key, with the area in it", &area},
          {prefix + ".orientation", "", "Handedness in the key", &orientation}};
}

TriangleKeys::TriangleKeys(const TriangleSettings& settings)
    : hashed_(settings.area),
      with_orientation_(settings.orientation),
      width_(static_cast<std::uint32_t>(settings.max_side_m / settings.step_m) + 2) {
  constexpr std::uint32_t hash_range = 50'000'000;
  if (hashed_) {
    count_ = hash_range;
    return;
  }
  row_.assign(static_cast<std::size_t>(width_) * width_, 0);
  std::uint32_t next = 0;
  for (std::uint32_t c = 0; c < width_; ++c) {
    for (std::uint32_t b = 0; b <= c; ++b) {
      // A triangle has l3 < l1 + l2; rounded down that is c <= a + b + 1.
      const std::uint32_t least = c > b + 1 ? c - b - 1 : 0;
      if (least > b) continue;
      row_[c * width_ + b] = next - least;  // may wrap around; adding a brings it back
      next += b - least + 1;
    }
  }
  count_ = with_orientation_ ? 2 * next : next;
}

std::uint32_t TriangleKeys::published_hash(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t area) {
  constexpr std::uint64_t rho = 100007;
  constexpr std::uint64_t range = 50'000'000;
  const std::uint64_t sides = ((c * rho + b) % range * rho + a) % range;
  return static_cast<std::uint32_t>((sides * rho + area) % range);
}

TriangleMaker::TriangleMaker(const TriangleSettings& settings) : settings_(settings), keys_(settings) {}

void TriangleMaker::find_neighbours() {
  const std::size_t n = tree_count_;
  distance_.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    distance_[i * n + i] = 0.0F;
    for (std::size_t j = i + 1; j < n; ++j) {
      const float dx = x_[i] - x_[j], dy = y_[i] - y_[j];
      distance_[i * n + j] = distance_[j * n + i] = std::sqrt(dx * dx + dy * dy);
    }
  }
  neighbour_count_ = std::min<std::size_t>(static_cast<std::size_t>(std::max(0, settings_.neighbours)), n > 0 ? n - 1 : 0);
  neighbours_.resize(n * neighbour_count_);
  is_neighbour_.assign(n * n, 0);
  std::pair<float, std::uint8_t> order[most_trees];
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t count = 0;
    for (std::size_t j = 0; j < n; ++j) {
      if (j != i) order[count++] = {distance_[i * n + j], static_cast<std::uint8_t>(j)};
    }
    std::nth_element(order, order + neighbour_count_, order + count);
    for (std::size_t m = 0; m < neighbour_count_; ++m) {
      neighbours_[i * neighbour_count_ + m] = order[m].second;
      is_neighbour_[i * n + order[m].second] = 1;
    }
  }
}

/// Has `center` both others among its neighbours, so that it makes the same triple?
bool TriangleMaker::made_by(std::size_t center, std::size_t other, std::size_t another) const {
  const std::uint8_t* row = is_neighbour_.data() + center * tree_count_;
  return row[other] != 0 && row[another] != 0;
}

void TriangleMaker::add_triangle(std::size_t i, std::size_t j, std::size_t k) {
  const std::size_t n = tree_count_;
  // Vertices with the side opposite, shortest side first.
  float side[3] = {distance_[j * n + k], distance_[i * n + k], distance_[i * n + j]};
  std::size_t tree[3] = {i, j, k};
  const auto order = [&](int a, int b) {
    if (side[b] < side[a]) std::swap(side[a], side[b]), std::swap(tree[a], tree[b]);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  if (side[0] < static_cast<float>(settings_.min_side_m) || side[2] > static_cast<float>(settings_.max_side_m)) return;
  const float x0 = x_[tree[0]], y0 = y_[tree[0]];
  const float ex = x_[tree[1]] - x0, ey = y_[tree[1]] - y0;  // along the longest side
  const float fx = x_[tree[2]] - x0, fy = y_[tree[2]] - y0;
  const float twice_area = ex * fy - ey * fx;
  const float per_step = 1.0F / static_cast<float>(settings_.step_m);
  const auto steps = [per_step](float length) { return static_cast<std::uint32_t>(length * per_step); };
  Triangle& t = triangles_.emplace_back();
  t.key = keys_.key(steps(side[0]), steps(side[1]), steps(side[2]), steps(std::abs(twice_area) / 2), twice_area > 0.0F);
  const float cx = x0 + (ex + fx) / 3.0F, cy = y0 + (ey + fy) / 3.0F;
  const float per_length = 1.0F / side[2];
  const float cosine = ex * per_length, sine = ey * per_length;
  t.origin_x_cm = centimetres(-(cosine * cx + sine * cy));
  t.origin_y_cm = centimetres(sine * cx - cosine * cy);
  t.yaw = turn_of(ex, ey);
  for (int v = 0; v < 3; ++v) {
    t.dbh_cm[v] = dbh_cm_[tree[v]];
    t.tree[v] = static_cast<std::uint8_t>(tree[v]);
  }
}

const std::vector<Triangle>& TriangleMaker::make(const Scene& scene) {
  tree_count_ = std::min(scene.trees.size(), most_trees);
  x_.resize(tree_count_);
  y_.resize(tree_count_);
  dbh_cm_.resize(tree_count_);
  for (std::size_t i = 0; i < tree_count_; ++i) {
    x_[i] = static_cast<float>(scene.trees[i].position_m.x());
    y_[i] = static_cast<float>(scene.trees[i].position_m.y());
    dbh_cm_[i] = static_cast<std::uint8_t>(std::clamp(std::lround(scene.trees[i].dbh_m * 100.0), 0L, 255L));
  }
  triangles_.clear();
  find_neighbours();
  for (std::size_t i = 0; i < tree_count_; ++i) {
    const std::uint8_t* near = neighbours_.data() + i * neighbour_count_;
    for (std::size_t a = 0; a < neighbour_count_; ++a) {
      for (std::size_t b = a + 1; b < neighbour_count_; ++b) {
        const std::size_t j = near[a], k = near[b];
        if ((j < i && made_by(j, i, k)) || (k < i && made_by(k, i, j))) continue;  // each triple once
        add_triangle(i, j, k);
      }
    }
  }
  return triangles_;
}

}  // namespace stemwise::treeloc
