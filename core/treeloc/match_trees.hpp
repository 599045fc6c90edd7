#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/treeloc/planar_pose.hpp"
#include "core/treeloc/scene.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// Positions and diameters of a scene's trees, side by side, in order of x.
struct PlanarTrees {
  std::span<const float> x_m;
  std::span<const float> y_m;
  std::span<const float> dbh_m;
  std::span<const std::uint8_t> strip_start;  ///< per strip of x the first tree in it or beyond
  float strips_per_m = 0.0F;
  std::size_t size() const { return x_m.size(); }
  /// A tree such that none before it has an x of `x` or more. O(1).
  std::size_t first_near(float x) const;
};

/// Scenes' trees in flat arrays.
class PlanarTreeStore {
public:
  static constexpr std::size_t strips = 64;  ///< of a scene's extent in x
  void add(const Scene& scene);
  void clear();
  PlanarTrees trees(std::size_t scene) const;
  std::size_t scene_count() const { return first_.size() - 1; }

private:
  void add_strips();

  std::vector<float> x_m_, y_m_, dbh_m_;
  std::vector<std::size_t> first_{0};
  std::vector<std::uint8_t> strip_start_;  ///< `strips` per scene
  std::vector<float> strips_per_m_;        ///< per scene
};

struct TreePair {
  std::uint16_t query = 0;
  std::uint16_t candidate = 0;
  float distance_sq = 0.0F;
};

/// Pairs the trees of a query with those of candidates, one to one. Keeps its buffers: one per thread.
class TreeMatcher {
public:
  explicit TreeMatcher(const MatchTreesSettings& settings);
  /// From a start pose: pairs within the coarse radius, new pose, and so on to the fine radius. Gives the final pose;
  /// `pairs()` are those within the fine radius of it. Stops where fewer than 3 pairs are left.
  PlanarPose match(const PlanarTrees& query, const PlanarTrees& candidate, PlanarPose start);
  /// One-to-one pairs within `radius_m` of a given pose, no new pose: what the result's `pairs()` hold.
  void pair(const PlanarTrees& query, const PlanarTrees& candidate, const PlanarPose& pose, double radius_m);
  std::span<const TreePair> pairs() const { return pairs_; }

private:
  PlanarPose fit(const PlanarTrees& query, const PlanarTrees& candidate, double radius_m);

  MatchTreesSettings settings_;
  std::vector<double> radii_m_;  ///< one per step
  std::vector<TreePair> best_of_candidate_;
  std::vector<TreePair> pairs_;
  std::vector<PlanarPair> points_;
};

}  // namespace stemwise::treeloc
