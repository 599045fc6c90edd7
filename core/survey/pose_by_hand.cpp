#include "core/survey/pose_by_hand.hpp"

#include <algorithm>
#include <cmath>

namespace stemwise {
namespace {

constexpr double together_m = 2.5;
constexpr double least_spread_m = 0.5;

struct PlacedPair {
  NamedPair stems;
  Eigen::Vector2d a_m, b_m;
};

std::vector<PlacedPair> places_of(const IndexedList& a, const IndexedList& b, const std::vector<NamedPair>& same_tree) {
  const auto node_with = [](const NodeList& nodes, std::size_t stem) -> std::optional<Eigen::Vector2d> {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (std::find(nodes.members[i].begin(), nodes.members[i].end(), stem) != nodes.members[i].end()) return nodes.at_m[i];
    return std::nullopt;
  };
  std::vector<PlacedPair> placed;
  for (const NamedPair& pair : same_tree) {
    const auto pa = node_with(a.nodes, pair.first), pb = node_with(b.nodes, pair.second);
    if (pa && pb) placed.push_back({pair, *pa, *pb});
  }
  return placed;
}

/// Least squares.
PlanarPose fit_pose(const std::vector<PlacedPair>& pairs) {
  Eigen::Vector2d mean_a = Eigen::Vector2d::Zero(), mean_b = Eigen::Vector2d::Zero();
  for (const PlacedPair& p : pairs) mean_a += p.a_m / static_cast<double>(pairs.size()), mean_b += p.b_m / static_cast<double>(pairs.size());
  double dot = 0.0, cross = 0.0;
  for (const PlacedPair& p : pairs) {
    const Eigen::Vector2d u = p.a_m - mean_a, v = p.b_m - mean_b;
    dot += u.dot(v), cross += u.x() * v.y() - u.y() * v.x();
  }
  PlanarPose pose{0.0, 0.0, std::atan2(cross, dot)};
  const Eigen::Vector2d shift = mean_b - pose * mean_a;
  pose.x_m = shift.x(), pose.y_m = shift.y();
  return pose;
}

bool brings_together(const PlanarPose& b_from_a, const PlacedPair& pair) { return (b_from_a * pair.a_m - pair.b_m).norm() < together_m; }

/// Every two pairs make a pose; the one that most pairs agree with, the first of equals.
std::vector<PlacedPair> largest_agreement(const std::vector<PlacedPair>& pairs) {
  std::vector<PlacedPair> best;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = i + 1; j < pairs.size(); ++j) {
      if ((pairs[i].a_m - pairs[j].a_m).norm() < least_spread_m) continue;
      const PlanarPose pose = fit_pose({pairs[i], pairs[j]});
      std::vector<PlacedPair> agreeing;
      std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(agreeing), [&](const PlacedPair& p) { return brings_together(pose, p); });
      if (agreeing.size() > best.size()) best = std::move(agreeing);
    }
  return best.size() >= 2 ? best : std::vector<PlacedPair>{};
}

PoseFit refined(const IndexedList& a, const IndexedList& b, const std::vector<PlacedPair>& agreeing, double noise_floor_m) {
  Scene scene;
  double spread_m = 0.0;
  for (const PlacedPair& p : agreeing) scene.centre_m += p.a_m / static_cast<double>(agreeing.size());
  for (const PlacedPair& p : agreeing) spread_m = std::max(spread_m, (p.a_m - scene.centre_m).norm());
  scene.radius_m = std::max(15.0, 1.5 * spread_m);
  a.index.within(scene.centre_m, scene.radius_m, [&](std::size_t i, double) { scene.nodes.push_back(i); });
  const PoseFit start{fit_pose(agreeing), 1.0, {false, 0.0, 1.0}, 0.0};
  PoseFit fit = refine_pose(a, scene.nodes, b, start, noise_floor_m);
  fit.dbh = refit_dbh(a, scene.nodes, b, fit);
  fit = grow_pose(a, scene, b, fit, noise_floor_m);
  const bool kept = std::all_of(agreeing.begin(), agreeing.end(), [&](const PlacedPair& p) { return brings_together(fit.b_from_a, p); });
  return kept ? fit : start;
}

}  // namespace

std::vector<NamedPair> pairs_apart(const IndexedList& a, const IndexedList& b, const PlanarPose& b_from_a, const std::vector<NamedPair>& same_tree) {
  std::vector<NamedPair> apart;
  for (const PlacedPair& p : places_of(a, b, same_tree))
    if (!brings_together(b_from_a, p)) apart.push_back(p.stems);
  return apart;
}

std::optional<HandPose> pose_by_hand(const IndexedList& a, const IndexedList& b, const std::vector<NamedPair>& same_tree, double noise_floor_m) {
  const std::vector<PlacedPair> pairs = places_of(a, b, same_tree);
  const auto apart = [&](const PlacedPair& p) { return (p.a_m - pairs.front().a_m).norm() >= least_spread_m; };
  if (pairs.size() < 2 || std::none_of(pairs.begin(), pairs.end(), apart)) return std::nullopt;
  HandPose pose;
  const std::vector<PlacedPair> agreeing = largest_agreement(pairs);
  for (const PlacedPair& p : agreeing) pose.agreeing.push_back(p.stems);
  if (!agreeing.empty()) pose.fit = refined(a, b, agreeing, noise_floor_m);
  for (const PlacedPair& p : pairs)
    if (agreeing.empty() || !brings_together(pose.fit.b_from_a, p)) pose.contradicted.push_back(p.stems);
  return pose;
}

}  // namespace stemwise
