#include "core/survey/match_stems.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/survey/assign_sparse.hpp"

namespace stemwise {
namespace {

constexpr double gate_in_sigmas = 7.0;
constexpr double narrowest_gate_m = 1.0, widest_gate_m = 6.0;

struct Problem {
  std::vector<AssignmentEdge> edges;
  std::vector<std::vector<std::size_t>> of_a, of_b;  ///< edges at each stem
};

Problem edges_between(const IndexedList& a, const IndexedList& b, const PoseFit& fit, const MatchPriors& priors, const MatchConstraints& constraints) {
  const PairEvidence evidence(a, b, fit);
  const PlanarMap map(fit.b_from_a);
  const double gate_m = std::clamp(gate_in_sigmas * fit.noise_m, narrowest_gate_m, widest_gate_m);
  const std::set<std::pair<std::size_t, std::size_t>> forbidden(constraints.must_not.begin(), constraints.must_not.end());
  std::set<std::size_t> fixed_a, fixed_b;
  for (const auto& [i, j] : constraints.must) fixed_a.insert(i), fixed_b.insert(j);
  Problem problem{{}, std::vector<std::vector<std::size_t>>(a.size()), std::vector<std::vector<std::size_t>>(b.size())};
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (fixed_a.contains(i)) continue;
    const double there = std::clamp(priors.presence_a.empty() ? priors.share_b : priors.presence_a[i], 0.01, 0.99);
    const double joined = 0.5 * std::log(priors.share_a * there) - std::log(1.0 - priors.share_a) - std::log(1.0 - there);
    b.index.within(map(a.nodes.at_m[i].x(), a.nodes.at_m[i].y()), gate_m, [&](std::size_t j, double d_sq) {
      if (fixed_b.contains(j) || forbidden.contains({i, j})) return;
      const double gain = evidence.log_ratio(i, j, d_sq) + joined + priors.species.log_ratio(i, j);
      if (gain <= -3.0) return;  // not even a second choice
      problem.of_a[i].push_back(problem.edges.size());
      problem.of_b[j].push_back(problem.edges.size());
      problem.edges.push_back({i, j, gain});
    });
  }
  return problem;
}

/// Fills confidence and second choice: what else these two could have been, less what it would cost those who hold it.
void weigh(StemMatch& match, std::size_t edge, const Problem& problem, const std::vector<double>& held_a, const std::vector<double>& held_b) {
  double others = 1.0, best = -1e300;  // 1: both stay alone
  const auto consider = [&](std::size_t k, bool same_a) {
    if (k == edge) return;
    const AssignmentEdge& other = problem.edges[k];
    const double left = other.gain - std::max(0.0, same_a ? held_b[other.right] : held_a[other.left]);
    others += std::exp(std::min(left, 700.0));
    if (left <= best) return;
    best = left;
    match.second_a = same_a ? std::nullopt : std::optional(other.left);
    match.second_b = same_a ? std::optional(other.right) : std::nullopt;
  };
  for (const std::size_t k : problem.of_a[match.a]) consider(k, true);
  for (const std::size_t k : problem.of_b[match.b]) consider(k, false);
  match.confidence = 1.0 / (1.0 + others * std::exp(std::max(-match.gain, -700.0)));
}

}  // namespace

std::vector<StemMatch> match_stems(const IndexedList& a, const IndexedList& b, const PoseFit& fit, const MatchPriors& priors, const MatchConstraints& constraints) {
  const Problem problem = edges_between(a, b, fit, priors, constraints);
  const auto chosen = assign_sparse(a.size(), b.size(), problem.edges);
  std::vector<double> held_a(a.size(), 0.0), held_b(b.size(), 0.0);
  for (const std::size_t k : chosen) held_a[problem.edges[k].left] = held_b[problem.edges[k].right] = problem.edges[k].gain;
  std::vector<StemMatch> result;
  for (const std::size_t k : chosen) {
    StemMatch match{problem.edges[k].left, problem.edges[k].right, problem.edges[k].gain, 0.0, false, {}, {}};
    weigh(match, k, problem, held_a, held_b);
    result.push_back(match);
  }
  std::set<std::size_t> used_a, used_b;
  for (const auto& [i, j] : constraints.must) {
    if (!used_a.insert(i).second || !used_b.insert(j).second) continue;  // two decisions for one stem: the first holds
    result.push_back({i, j, 0.0, 1.0, true, {}, {}});
  }
  std::sort(result.begin(), result.end(), [](const StemMatch& p, const StemMatch& q) { return p.a < q.a; });
  return result;
}

}  // namespace stemwise
