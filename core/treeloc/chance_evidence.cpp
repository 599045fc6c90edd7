#include "core/treeloc/chance_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stemwise::treeloc {
namespace {

/// Share of the pairs of trees whose diameters agree.
double agreeing_share(const PlanarTrees& query, const PlanarTrees& candidate, double tau_dbh_m) {
  std::size_t agree = 0;
  for (const float q : query.dbh_m) {
    for (const float c : candidate.dbh_m) agree += std::abs(q - c) < static_cast<float>(tau_dbh_m) ? 1 : 0;
  }
  return static_cast<double>(agree) / static_cast<double>(query.size() * candidate.size());
}

/// Trees per square metre, from the mean squared distance to their middle (a uniform disc has R^2 / 2).
double density_per_sq_m(const PlanarTrees& trees) {
  const double n = static_cast<double>(trees.size());
  double mean_x = 0.0, mean_y = 0.0, spread = 0.0;
  for (std::size_t i = 0; i < trees.size(); ++i) mean_x += trees.x_m[i] / n, mean_y += trees.y_m[i] / n;
  for (std::size_t i = 0; i < trees.size(); ++i)
    spread += (std::pow(trees.x_m[i] - mean_x, 2) + std::pow(trees.y_m[i] - mean_y, 2)) / n;
  return n / (std::numbers::pi * std::max(1.0, 2.0 * spread));
}

}  // namespace

double chance_evidence(int pairs, const PlanarTrees& query, const PlanarTrees& candidate, double radius_m, double tau_dbh_m,
                       double gate_m, std::size_t scenes) {
  if (pairs <= 0 || query.size() == 0 || candidate.size() == 0) return 0.0;
  const double area_sq_m = std::numbers::pi * radius_m * radius_m;
  const double lambda =
      static_cast<double>(query.size()) * density_per_sq_m(candidate) * area_sq_m * agreeing_share(query, candidate, tau_dbh_m);
  const double k = pairs;
  if (k <= lambda) return 0.0;
  const double shifts = std::numbers::pi * gate_m * gate_m / (radius_m * radius_m);
  const double turns = 2.0 * std::numbers::pi * 15.0 / radius_m;  // half a scene away a turn of one radius makes a new pose
  const double poses = shifts * turns * static_cast<double>(std::max<std::size_t>(scenes, 1));
  return k * std::log(k / std::max(lambda, 1e-3)) - k + lambda - std::log(poses);
}

}  // namespace stemwise::treeloc
