#include "core/survey/refine_pose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stemwise {
namespace {

constexpr double prior_common = 0.6;      // of a stem to have a partner
constexpr double gate_in_sigmas = 3.0;
constexpr int most_steps = 30;
constexpr std::size_t least_pairs_for_dbh = 8;

struct SoftPair {
  std::size_t a = 0, b = 0;
  double weight = 0.0;
};

std::vector<SoftPair> soft_matches(const IndexedList& a, std::span<const std::size_t> nodes, const IndexedList& b, const PoseFit& fit) {
  const PlanarMap map(fit.b_from_a);
  const double variance = fit.noise_m * fit.noise_m;
  std::vector<SoftPair> pairs;
  for (const std::size_t i : nodes) {
    const std::size_t first = pairs.size();
    double sum = 1.0 - prior_common;
    b.index.within(map(a.nodes.at_m[i].x(), a.nodes.at_m[i].y()), gate_in_sigmas * fit.noise_m, [&](std::size_t j, double d_sq) {
      const double near = std::exp(-0.5 * d_sq / variance) / (2.0 * std::numbers::pi * variance);
      const double evidence = dbh_evidence(fit.dbh, a.nodes.dbh_cm[i], b.nodes.dbh_cm[j], b.dbh_density_at[j]);
      const double ratio = prior_common * near * evidence / b.density_per_sq_m[j];
      sum += ratio;
      pairs.push_back({i, j, ratio});
    });
    for (std::size_t k = first; k < pairs.size(); ++k) pairs[k].weight /= sum;
  }
  return pairs;
}

/// The rigid pose of least weighted squares, closed form.
PlanarPose fit_rigid(const IndexedList& a, const IndexedList& b, const std::vector<SoftPair>& pairs) {
  double total = 0.0;
  Eigen::Vector2d mean_a = Eigen::Vector2d::Zero(), mean_b = Eigen::Vector2d::Zero();
  for (const auto& p : pairs) {
    total += p.weight;
    mean_a += p.weight * a.nodes.at_m[p.a];
    mean_b += p.weight * b.nodes.at_m[p.b];
  }
  mean_a /= total, mean_b /= total;
  double dot = 0.0, cross = 0.0;
  for (const auto& p : pairs) {
    const Eigen::Vector2d u = a.nodes.at_m[p.a] - mean_a, v = b.nodes.at_m[p.b] - mean_b;
    dot += p.weight * u.dot(v);
    cross += p.weight * (u.x() * v.y() - u.y() * v.x());
  }
  PlanarPose pose{0.0, 0.0, std::atan2(cross, dot)};
  const Eigen::Vector2d shift = mean_b - pose * mean_a;
  pose.x_m = shift.x(), pose.y_m = shift.y();
  return pose;
}

double noise_of(const IndexedList& a, const IndexedList& b, const std::vector<SoftPair>& pairs, const PlanarPose& pose) {
  const PlanarMap map(pose);
  double total = 0.0, sum_sq = 0.0;
  for (const auto& p : pairs) {
    total += p.weight;
    sum_sq += p.weight * (map(a.nodes.at_m[p.a].x(), a.nodes.at_m[p.a].y()) - b.nodes.at_m[p.b]).squaredNorm();
  }
  return std::sqrt(sum_sq / (2.0 * total));
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

PoseFit refine_pose(const IndexedList& a, std::span<const std::size_t> nodes, const IndexedList& b, PoseFit fit, double noise_floor_m) {
  const double widest_m = fit.noise_m;
  for (int step = 0; step < most_steps; ++step) {
    const auto pairs = soft_matches(a, nodes, b, fit);
    fit.soft_matched = 0.0;
    for (const auto& p : pairs) fit.soft_matched += p.weight;
    if (fit.soft_matched < 2.0) break;
    const PlanarPose before = fit.b_from_a;
    fit.b_from_a = fit_rigid(a, b, pairs);
    const double noise_before_m = fit.noise_m;
    fit.noise_m = std::clamp(noise_of(a, b, pairs, fit.b_from_a), std::max(noise_floor_m, 0.75 * fit.noise_m), std::max(noise_floor_m, widest_m));
    const Eigen::Vector2d there = a.nodes.at_m[nodes.front()];
    const bool still = (fit.b_from_a * there - before * there).norm() < 1e-3 && std::abs(fit.b_from_a.yaw_rad - before.yaw_rad) < 1e-5;
    if (still && std::abs(fit.noise_m - noise_before_m) < 0.01 * noise_before_m) break;
  }
  return fit;
}

DbhModel refit_dbh(const IndexedList& a, std::span<const std::size_t> nodes, const IndexedList& b, const PoseFit& fit) {
  std::vector<double> change_cm, of_usual;
  std::vector<SoftPair> sure;
  for (const auto& p : soft_matches(a, nodes, b, fit))
    if (p.weight > 0.5 && a.nodes.dbh_cm[p.a] > 0.0 && b.nodes.dbh_cm[p.b] > 0.0) sure.push_back(p);
  if (sure.size() < least_pairs_for_dbh) return fit.dbh;
  for (const auto& p : sure) change_cm.push_back(b.nodes.dbh_cm[p.b] - a.nodes.dbh_cm[p.a]);
  const double growth_cm = median_of(change_cm);
  for (std::size_t k = 0; k < sure.size(); ++k)
    of_usual.push_back(std::abs(change_cm[k] - growth_cm) / dbh_sd_cm({true, 0.0, 1.0}, a.nodes.dbh_cm[sure[k].a]));
  return {true, growth_cm, std::clamp(1.4826 * median_of(of_usual), 0.35, 3.0)};
}

}  // namespace stemwise
