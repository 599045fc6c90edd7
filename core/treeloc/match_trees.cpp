#include "core/treeloc/match_trees.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemwise::treeloc {

void PlanarTreeStore::add(const Scene& scene) {
  const auto by_x = [](const SceneTree& a, const SceneTree& b) { return a.position_m.x() < b.position_m.x(); };
  if (!std::is_sorted(scene.trees.begin(), scene.trees.end(), by_x))
    throw std::logic_error("a scene's trees are not in order of x");
  for (const SceneTree& tree : scene.trees) {
    x_m_.push_back(static_cast<float>(tree.position_m.x()));
    y_m_.push_back(static_cast<float>(tree.position_m.y()));
    dbh_m_.push_back(static_cast<float>(tree.dbh_m));
  }
  first_.push_back(x_m_.size());
  add_strips();
}

void PlanarTreeStore::add_strips() {
  const std::size_t first = first_[first_.size() - 2], count = first_.back() - first;
  const float* x = x_m_.data() + first;
  const float extent_m = count > 0 ? x[count - 1] - x[0] : 0.0F;
  const float per_m = extent_m > 0.0F ? static_cast<float>(strips) / extent_m : 0.0F;
  strips_per_m_.push_back(per_m);
  std::size_t tree = 0;
  for (std::size_t strip = 0; strip < strips; ++strip) {
    while (tree < count && static_cast<std::size_t>((x[tree] - x[0]) * per_m) < strip) ++tree;
    strip_start_.push_back(static_cast<std::uint8_t>(tree));
  }
}

void PlanarTreeStore::clear() {
  x_m_.clear();
  y_m_.clear();
  dbh_m_.clear();
  strip_start_.clear();
  strips_per_m_.clear();
  first_.assign(1, 0);
}

std::size_t PlanarTrees::first_near(float x) const {
  if (x_m.empty()) return 0;
  const float strip = (x - x_m.front()) * strips_per_m;  // the same expression as in add_strips: it grows with x
  if (!(strip > 0.0F)) return 0;
  return strip_start[std::min(static_cast<std::size_t>(strip), strip_start.size() - 1)];
}

PlanarTrees PlanarTreeStore::trees(std::size_t scene) const {
  const std::size_t first = first_[scene], count = first_[scene + 1] - first;
  return {{x_m_.data() + first, count},
          {y_m_.data() + first, count},
          {dbh_m_.data() + first, count},
          {strip_start_.data() + scene * strips, strips},
          strips_per_m_[scene]};
}

Fields MatchTreesSettings::fields(const std::string& prefix) {
  return {{prefix + ".coarse_m", "m", "First radius in which trees are paired", &coarse_m},
          {prefix + ".fine_m", "m", "Last radius: a pair within it counts", &fine_m},
          {prefix + ".steps", "", "Poses solved on the way from the first radius to the last", &steps},
          {prefix + ".tau_dbh_m", "m", "Diameters of a pair differ by at most this", &tau_dbh_m}};
}

TreeMatcher::TreeMatcher(const MatchTreesSettings& settings) : settings_(settings) {
  for (int step = 0; step < settings.steps; ++step) {
    const double fraction = settings.steps > 1 ? static_cast<double>(step) / (settings.steps - 1) : 1.0;
    radii_m_.push_back(settings.coarse_m * std::pow(settings.fine_m / settings.coarse_m, fraction));
  }
}

void TreeMatcher::pair(const PlanarTrees& query, const PlanarTrees& candidate, const PlanarPose& pose, double radius_m) {
  const auto cosine = static_cast<float>(pose.cosine), sine = static_cast<float>(pose.sine);
  const auto shift_x = static_cast<float>(pose.x_m), shift_y = static_cast<float>(pose.y_m);
  const auto tau_dbh = static_cast<float>(settings_.tau_dbh_m);
  const auto radius = static_cast<float>(radius_m);
  const float radius_sq = radius * radius;
  const std::size_t count = candidate.size();
  best_of_candidate_.assign(count, {0, 0, radius_sq});
  for (std::size_t i = 0; i < query.size(); ++i) {
    const float x = cosine * query.x_m[i] - sine * query.y_m[i] + shift_x;
    const float y = sine * query.x_m[i] + cosine * query.y_m[i] + shift_y;
    const float dbh = query.dbh_m[i];
    float nearest_sq = radius_sq;
    std::size_t nearest = count;
    // Trees lie in order of x: only a narrow strip of them can be near enough.
    for (std::size_t j = candidate.first_near(x - radius); j < count && candidate.x_m[j] <= x + radius; ++j) {
      const float dx = x - candidate.x_m[j], dy = y - candidate.y_m[j];
      const float distance_sq = dx * dx + dy * dy;
      if (distance_sq < nearest_sq && std::abs(dbh - candidate.dbh_m[j]) < tau_dbh) nearest_sq = distance_sq, nearest = j;
    }
    if (nearest < count && nearest_sq < best_of_candidate_[nearest].distance_sq) {
      best_of_candidate_[nearest] = {static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(nearest), nearest_sq};
    }
  }
  pairs_.clear();
  for (const TreePair& p : best_of_candidate_) {
    if (p.distance_sq < radius_sq) pairs_.push_back(p);
  }
}

PlanarPose TreeMatcher::fit(const PlanarTrees& query, const PlanarTrees& candidate, double radius_m) {
  points_.clear();
  const double scale_sq = 0.25 * radius_m * radius_m;
  for (const TreePair& p : pairs_) {
    points_.push_back({{query.x_m[p.query], query.y_m[p.query]},
                       {candidate.x_m[p.candidate], candidate.y_m[p.candidate]},
                       1.0 / (1.0 + static_cast<double>(p.distance_sq) / scale_sq)});
  }
  return fit_planar_pose(points_);
}

PlanarPose TreeMatcher::match(const PlanarTrees& query, const PlanarTrees& candidate, PlanarPose start) {
  PlanarPose pose = start;
  for (const double radius_m : radii_m_) {
    pair(query, candidate, pose, radius_m);
    if (pairs_.size() < 3) return pose;
    pose = fit(query, candidate, radius_m);
  }
  pair(query, candidate, pose, settings_.fine_m);
  return pose;
}

}  // namespace stemwise::treeloc
