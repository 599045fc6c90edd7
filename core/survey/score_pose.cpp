#include "core/survey/score_pose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace stemwise {
namespace {

constexpr double gate_in_sigmas = 6.0;
constexpr double widest_gate_m = 6.0;
constexpr double least_share = 0.05, greatest_share = 0.97;

struct Candidate {
  double log_ratio = 0.0;
  std::size_t a = 0, b = 0;
  bool operator<(const Candidate& o) const {
    if (log_ratio != o.log_ratio) return log_ratio > o.log_ratio;
    return a != o.a ? a < o.a : b < o.b;
  }
};

double share_of(double matched, int inside) {
  return std::clamp(matched / std::max(1.0, static_cast<double>(inside)), least_share, greatest_share);
}

std::vector<std::size_t> all_of(std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<std::size_t> inside_of(const std::vector<std::size_t>& nodes, const IndexedList& list, const IndexedList& other, const PlanarPose& other_from_list) {
  const PlanarMap map(other_from_list);
  std::vector<std::size_t> result;
  for (const std::size_t i : nodes)
    if (other.support.contains(map(list.nodes.at_m[i].x(), list.nodes.at_m[i].y()))) result.push_back(i);
  return result;
}

struct Joined {
  std::vector<Candidate> pairs;
  double sum = 0.0;
};

/// Greedy one-to-one, the best pair first.
Joined join(const std::vector<Candidate>& sorted, double threshold, std::vector<std::uint8_t>& used_a, std::vector<std::uint8_t>& used_b) {
  Joined joined;
  for (const Candidate& c : sorted) {
    if (c.log_ratio <= threshold) break;
    if (used_a[c.a] != 0 || used_b[c.b] != 0) continue;
    used_a[c.a] = used_b[c.b] = 1;
    joined.pairs.push_back(c);
    joined.sum += c.log_ratio;
  }
  for (const Candidate& c : joined.pairs) used_a[c.a] = used_b[c.b] = 0;
  return joined;
}

void set_extent(PoseScore& score, const IndexedList& a, const std::vector<Candidate>& pairs) {
  if (pairs.empty()) return;
  for (const auto& c : pairs) score.centre_m += a.nodes.at_m[c.a] / static_cast<double>(pairs.size());
  double sum_sq = 0.0;
  for (const auto& c : pairs) sum_sq += (a.nodes.at_m[c.a] - score.centre_m).squaredNorm();
  score.radius_m = std::sqrt(sum_sq / static_cast<double>(pairs.size()));
}

}  // namespace

PairEvidence::PairEvidence(const IndexedList& list_a, const IndexedList& list_b, const PoseFit& fit)
    : a_(list_a), b_(list_b), variance_(fit.noise_m * fit.noise_m), forth_(fit.dbh), back_(fit.dbh) {
  back_.growth_cm = -back_.growth_cm;
}

double PairEvidence::log_ratio(std::size_t i, std::size_t j, double distance_sq) const {
  const double u = distance_sq / variance_;
  const double near = (0.92 * std::exp(-0.5 * u) + 0.08 / 9.0 * std::exp(-u / 18.0)) / (2.0 * std::numbers::pi * variance_);
  const double forth = dbh_evidence(forth_, a_.nodes.dbh_cm[i], b_.nodes.dbh_cm[j], b_.dbh_density_at[j]);
  const double back = dbh_evidence(back_, b_.nodes.dbh_cm[j], a_.nodes.dbh_cm[i], a_.dbh_density_at[i]);
  return std::log(near) + 0.5 * std::log(forth * back / (a_.density_per_sq_m[i] * b_.density_per_sq_m[j]));
}

PoseScore score_pose(const IndexedList& a, const IndexedList& b, const PoseFit& fit, const Scene* scene) {
  std::vector<std::size_t> nodes_b;
  if (scene != nullptr)
    b.index.within(fit.b_from_a * scene->centre_m, scene->radius_m, [&](std::size_t j, double) { nodes_b.push_back(j); });
  else
    nodes_b = all_of(b.size());
  const auto a_inside = inside_of(scene != nullptr ? scene->nodes : all_of(a.size()), a, b, fit.b_from_a);
  const auto b_inside = inside_of(nodes_b, b, a, fit.b_from_a.inverse());
  PoseScore score;
  score.a_inside = static_cast<int>(a_inside.size());
  score.b_inside = static_cast<int>(b_inside.size());
  const PairEvidence evidence(a, b, fit);
  const PlanarMap map(fit.b_from_a);
  std::vector<std::uint8_t> used_a(a.size(), 0), used_b(b.size(), 1);
  for (const std::size_t j : b_inside) used_b[j] = 0;
  std::vector<Candidate> candidates;
  for (const std::size_t i : a_inside)
    b.index.within(map(a.nodes.at_m[i].x(), a.nodes.at_m[i].y()), std::min(gate_in_sigmas * fit.noise_m, widest_gate_m), [&](std::size_t j, double d_sq) {
      if (used_b[j] == 0) candidates.push_back({evidence.log_ratio(i, j, d_sq), i, j});
    });
  std::sort(candidates.begin(), candidates.end());
  Joined joined;
  score.share_a = score.share_b = 0.6;
  for (int round = 0; round < 3; ++round) {
    const double log_share = 0.5 * std::log(score.share_a * score.share_b);
    const double alone = std::log(1.0 - score.share_a) + std::log(1.0 - score.share_b);
    joined = join(candidates, alone - log_share, used_a, used_b);
    const auto matched = static_cast<double>(joined.pairs.size());
    score.share_b = share_of(matched, score.a_inside);
    score.share_a = share_of(matched, score.b_inside);
  }
  score.matched = static_cast<int>(joined.pairs.size());
  score.log_likelihood_ratio = score.matched * (1.0 + 0.5 * std::log(score.share_a * score.share_b)) + joined.sum +
                               (score.a_inside - score.matched) * std::log(1.0 - score.share_b) +
                               (score.b_inside - score.matched) * std::log(1.0 - score.share_a);
  set_extent(score, a, joined.pairs);
  return score;
}

double distance_between_m(const PlanarPose& p, const PlanarPose& q, const PoseScore& score) {
  const double shift_m = (p * score.centre_m - q * score.centre_m).norm();
  const double chord_m = 2.0 * std::sin(0.5 * std::abs(wrap_angle(p.yaw_rad - q.yaw_rad))) * score.radius_m;
  return std::hypot(shift_m, chord_m);
}

}  // namespace stemwise
