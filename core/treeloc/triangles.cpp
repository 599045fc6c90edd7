#include "core/treeloc/triangles.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/wide_vectors.hpp"

namespace stemwise::treeloc {
namespace {

constexpr std::size_t most_trees = Scene::most_trees;

using TreeSet = std::array<std::uint64_t, 4>;

void insert(TreeSet& set, std::size_t tree) { set[tree / 64] |= std::uint64_t{1} << (tree % 64); }
bool contains(const TreeSet& set, std::size_t tree) { return (set[tree / 64] >> (tree % 64) & 1U) != 0; }

/// Word `word` of the set of all trees below `tree`.
std::uint64_t below(std::size_t tree, std::size_t word) {
  if (tree >= (word + 1) * 64) return ~std::uint64_t{0};
  return tree <= word * 64 ? 0 : (std::uint64_t{1} << (tree % 64)) - 1;
}

/// How many are at most `radius`.
STEMWISE_WIDE_VECTORS std::int32_t count_within(const float* distances, std::size_t size, float radius) {
  std::int32_t count = 0;
  for (std::size_t i = 0; i < size; ++i) count += distances[i] <= radius ? 1 : 0;
  return count;
}

STEMWISE_WIDE_VECTORS void measure_from(float x, float y, const float* xs, const float* ys, float* distances, std::size_t size) {
  for (std::size_t j = 0; j < size; ++j) {
    const float dx = x - xs[j], dy = y - ys[j];
    distances[j] = std::sqrt(dx * dx + dy * dy);
  }
}

/// A radius, and whether exactly as many trees as wanted lie inside.
struct Radius {
  float length;
  bool exact;
};

/// A radius with `wanted` trees inside, or the distance of the `wanted`-th where several are exactly as far. Distances are
/// halved between by their bits, which are in order as whole numbers; but the first steps go where the counts point to from a
/// guess, and the radius of the tree before is nearly always a good one: counting a few times is quicker than sorting.
Radius radius_of_nearest(std::span<const float> distances, std::size_t wanted, float guess) {
  constexpr int pointed_steps = 8;
  const auto enough = static_cast<std::int32_t>(wanted);
  std::int32_t too_few = -1, high = std::bit_cast<std::int32_t>(std::numeric_limits<float>::max());
  float radius = guess;
  for (int step = 0; high - too_few > 1; ++step) {
    const std::int32_t count = count_within(distances.data(), distances.size(), radius);
    if (count == enough) return {radius, true};
    (count < enough ? too_few : high) = std::bit_cast<std::int32_t>(radius);
    // The number inside grows with the square of the radius.
    const float pointed = radius * std::sqrt((static_cast<float>(enough) + 0.5F) / (static_cast<float>(count) + 0.5F));
    const auto bits = std::bit_cast<std::int32_t>(pointed);
    const bool follow = step < pointed_steps && bits > too_few && bits < high;
    radius = follow ? pointed : std::bit_cast<float>(too_few + (high - too_few) / 2);
  }
  return {std::bit_cast<float>(high), false};
}

/// The `wanted` nearest: all inside the radius where they are as many; more are only where several are exactly as far, and then
/// those with the lower numbers count.
TreeSet nearest_of(std::span<const float> distances, std::size_t wanted, Radius radius) {
  TreeSet set{};
  for (std::size_t j = 0; j < distances.size(); ++j) set[j / 64] |= std::uint64_t{distances[j] <= radius.length} << (j % 64);
  if (radius.exact) return set;
  std::size_t count = 0;
  for (const std::uint64_t word : set) count += static_cast<std::size_t>(std::popcount(word));
  for (std::size_t j = distances.size(); j-- > 0 && count > wanted;) {
    if (distances[j] != radius.length) continue;
    set[j / 64] &= ~(std::uint64_t{1} << (j % 64));
    --count;
  }
  return set;
}

template <class Take>
void each(const TreeSet& set, std::size_t words, Take take) {
  for (std::size_t w = 0; w < words; ++w) {
    for (std::uint64_t left = set[w]; left != 0; left &= left - 1)
      take(w * 64 + static_cast<std::size_t>(std::countr_zero(left)));
  }
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

TriangleMaker::TriangleMaker(const TriangleSettings& settings) : settings_(settings), keys_(settings) {
  settings_.neighbours = std::clamp(settings_.neighbours, 0, static_cast<int>(TriangleBatch::most_neighbours));  // as Settings::check asks
}

void TriangleMaker::measure_distances() {
  const std::size_t n = tree_count_;
  distance_.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    float* row = distance_.data() + i * n;
    measure_from(x_[i], y_[i], x_.data(), y_.data(), row, n);
    row[i] = std::numeric_limits<float>::infinity();  // no tree is its own neighbour
  }
}

void TriangleMaker::find_neighbours() {
  const std::size_t n = tree_count_;
  const auto wanted = std::min(static_cast<std::size_t>(settings_.neighbours), n > 0 ? n - 1 : 0);
  neighbours_.assign(n, {});
  neighbour_of_.assign(n, {});
  float guess_m = 0.5F * static_cast<float>(settings_.max_side_m);
  for (std::size_t i = 0; i < n && wanted > 0; ++i) {
    const std::span<const float> from_i(distance_.data() + i * n, n);
    const Radius radius = radius_of_nearest(from_i, wanted, guess_m);
    guess_m = radius.length;
    neighbours_[i] = nearest_of(from_i, wanted, radius);
    each(neighbours_[i], words_, [&](std::size_t other) { insert(neighbour_of_[other], i); });
  }
}

/// The third trees of the triples that `center` makes with its neighbour `other` and those beyond it: neighbours of `center`
/// as well, but for triples that a tree before `center` makes too (each triple once).
TreeSet TriangleMaker::partners(std::size_t center, std::size_t other) const {
  const TreeSet &near = neighbours_[center], &of_center = neighbour_of_[center], &of_other = neighbour_of_[other];
  const bool other_comes_first = other < center && contains(neighbours_[other], center);
  TreeSet set{};
  for (std::size_t w = 0; w < words_; ++w) {
    set[w] = near[w] & ~below(other + 1, w) & ~(of_center[w] & of_other[w] & below(center, w));
    if (other_comes_first) set[w] &= ~neighbours_[other][w];
  }
  return set;
}

void TriangleMaker::add_triangles_of(std::size_t center) {
  const float* from_center = distance_.data() + center * tree_count_;
  const auto tree = [&](std::size_t i) { return TriangleBatch::Tree{x_[i], y_[i], static_cast<std::int32_t>(i)}; };
  batch_.clear(tree(center));
  each(neighbours_[center], words_, [&](std::size_t j) {
    const float* from_j = distance_.data() + j * tree_count_;
    each(partners(center, j), words_,
         [&](std::size_t k) { batch_.add(tree(j), tree(k), from_j[k], from_center[k], from_center[j]); });
  });
  batch_.compute(1.0F / static_cast<float>(settings_.step_m), static_cast<float>(settings_.min_side_m),
                 static_cast<float>(settings_.max_side_m));
  append(batch_);
}

void TriangleMaker::append(const TriangleBatch& batch) {
  const auto steps = [](std::int32_t n) { return static_cast<std::uint32_t>(n); };
  const std::size_t first = triangles_.size();
  triangles_.resize(first + batch.size());
  Triangle* out = triangles_.data() + first;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const TriangleBatch::Made made = batch.made(i);
    if (!made.within) continue;
    out->key =
        keys_.key(steps(made.steps[0]), steps(made.steps[1]), steps(made.steps[2]), steps(made.area), made.left_handed != 0);
    out->origin = {static_cast<std::int16_t>(made.origin_x_cm), static_cast<std::int16_t>(made.origin_y_cm)};
    out->yaw = static_cast<std::uint8_t>(made.yaw);
    for (int v = 0; v < 3; ++v) {
      out->tree[v] = static_cast<std::uint8_t>(made.trees >> 8 * v);
      out->dbh_cm[v] = dbh_cm_[out->tree[v]];
    }
    ++out;
  }
  triangles_.resize(static_cast<std::size_t>(out - triangles_.data()));
}

const std::vector<Triangle>& TriangleMaker::make(const Scene& scene) {
  tree_count_ = std::min(scene.trees.size(), most_trees);
  words_ = (tree_count_ + 63) / 64;
  x_.resize(tree_count_);
  y_.resize(tree_count_);
  dbh_cm_.resize(tree_count_);
  for (std::size_t i = 0; i < tree_count_; ++i) {
    x_[i] = static_cast<float>(scene.trees[i].position_m.x());
    y_[i] = static_cast<float>(scene.trees[i].position_m.y());
    dbh_cm_[i] = static_cast<std::uint8_t>(std::clamp(std::lround(scene.trees[i].dbh_m * 100.0), 0L, 255L));
  }
  triangles_.clear();
  measure_distances();
  find_neighbours();
  for (std::size_t i = 0; i < tree_count_; ++i) add_triangles_of(i);
  return triangles_;
}

}  // namespace stemwise::treeloc
