#include "core/treeloc/paired_tests.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/quantile.hpp"
#include "core/base/random.hpp"

namespace stemwise::treeloc {
namespace {

/// log of n over k.
double log_choose(int n, int k) { return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0); }

struct Ranked {
  double size = 0.0;
  bool a_larger = false;
  double rank = 0.0;
};

/// Ranks by size, ties sharing the mean; gives the sum of t^3 - t over groups of ties.
double give_ranks(std::vector<Ranked>& values) {
  std::sort(values.begin(), values.end(), [](const Ranked& x, const Ranked& y) { return x.size < y.size; });
  double ties = 0.0;
  for (std::size_t from = 0, to = 0; from < values.size(); from = to) {
    while (to < values.size() && values[to].size == values[from].size) ++to;
    const auto group = static_cast<double>(to - from);
    for (std::size_t i = from; i < to; ++i) values[i].rank = 0.5 * static_cast<double>(from + 1 + to);
    ties += group * group * group - group;
  }
  return ties;
}

/// Two-sided tail of the rank sum of n pairs without ties: how many of the 2^n signings are at least as far from the middle.
double exact_rank_p(int n, double rank_sum) {
  const int total = n * (n + 1) / 2;
  std::vector<double> ways(static_cast<std::size_t>(total) + 1, 0.0);
  ways[0] = 1.0;
  for (int rank = 1; rank <= n; ++rank) {
    for (int sum = total; sum >= rank; --sum) ways[static_cast<std::size_t>(sum)] += ways[static_cast<std::size_t>(sum - rank)];
  }
  const double smaller = std::min(rank_sum, total - rank_sum);
  double tail = 0.0;
  for (int sum = 0; sum <= static_cast<int>(std::lround(smaller)); ++sum) tail += ways[static_cast<std::size_t>(sum)];
  return std::min(1.0, 2.0 * tail * std::pow(2.0, -n));
}

using Rows = std::vector<QueryRow>;

/// The figures that are bootstrapped, of one sample of queries.
std::array<double, 7> figures_of(const Rows& rows, const EvaluateSettings& protocol) {
  const RetrievalMetrics r = retrieval_metrics(rows, protocol.thresholds);
  const PoseMetrics p = pose_metrics(rows, protocol, true);
  return {r.recall_at_1, r.mf1, r.auc, p.r50, p.sr, p.ate_m, p.are_deg};
}
constexpr std::array<const char*, 7> figure_names{"recall_at_1", "mf1", "auc", "r50_3d", "sr_3d", "ate_m", "are_deg"};

std::vector<BootstrapDifference> bootstrap(const Rows& a, const Rows& b, const EvaluateSettings& protocol, int resamples,
                                           std::uint64_t seed) {
  const auto all_a = figures_of(a, protocol), all_b = figures_of(b, protocol);
  std::array<std::vector<double>, 7> differences;
  EvaluateSettings coarse = protocol;
  coarse.thresholds = std::min(protocol.thresholds, 200);
  for (int sample = 0; sample < resamples; ++sample) {
    Random random(seed, static_cast<std::uint64_t>(sample) + 1);
    Rows sample_a, sample_b;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const std::size_t drawn = random.below(a.size());
      sample_a.push_back(a[drawn]);
      sample_b.push_back(b[drawn]);
    }
    const auto fa = figures_of(sample_a, coarse), fb = figures_of(sample_b, coarse);
    for (std::size_t f = 0; f < fa.size(); ++f) differences[f].push_back(fa[f] - fb[f]);
  }
  std::vector<BootstrapDifference> result;
  for (std::size_t f = 0; f < differences.size(); ++f) {
    BootstrapDifference d{figure_names[f], all_a[f], all_b[f], all_a[f] - all_b[f], 0.0, 0.0};
    std::sort(differences[f].begin(), differences[f].end());
    if (!differences[f].empty()) d.low = quantile_of_sorted(differences[f], 0.025), d.high = quantile_of_sorted(differences[f], 0.975);
    result.push_back(d);
  }
  return result;
}

McNemar by_rows(const Rows& a, const Rows& b, const std::function<bool(const QueryRow&)>& success) {
  std::vector<char> in_a, in_b;
  for (const QueryRow& row : a) in_a.push_back(success(row) ? 1 : 0);
  for (const QueryRow& row : b) in_b.push_back(success(row) ? 1 : 0);
  return exact_mcnemar(in_a, in_b);
}

}  // namespace

McNemar exact_mcnemar(std::span<const char> success_a, std::span<const char> success_b) {
  McNemar test;
  for (std::size_t i = 0; i < std::min(success_a.size(), success_b.size()); ++i) {
    if (success_a[i] != 0 && success_b[i] == 0) ++test.only_a;
    if (success_a[i] == 0 && success_b[i] != 0) ++test.only_b;
  }
  const int n = test.only_a + test.only_b;
  double tail = 0.0;
  for (int k = 0; k <= std::min(test.only_a, test.only_b); ++k) tail += std::exp(log_choose(n, k) - n * std::log(2.0));
  test.p = std::min(1.0, 2.0 * tail);
  return test;
}

Wilcoxon wilcoxon_signed_rank(std::span<const double> a, std::span<const double> b) {
  Wilcoxon test;
  std::vector<Ranked> values;
  std::vector<double> differences;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    differences.push_back(a[i] - b[i]);
    if (a[i] != b[i]) values.push_back({std::abs(a[i] - b[i]), a[i] > b[i], 0.0});
  }
  test.median_difference = median(differences);
  test.pairs = static_cast<int>(values.size());
  if (values.empty()) return test;
  const double ties = give_ranks(values);
  for (const Ranked& v : values) test.rank_sum += v.a_larger ? v.rank : 0.0;
  constexpr int exact_up_to = 50;
  if (ties == 0.0 && test.pairs <= exact_up_to) {
    test.p = exact_rank_p(test.pairs, test.rank_sum);
    return test;
  }
  const double n = test.pairs, middle = n * (n + 1) / 4.0;
  const double variance = n * (n + 1) * (2 * n + 1) / 24.0 - ties / 48.0;
  const double z = std::max(0.0, std::abs(test.rank_sum - middle) - 0.5) / std::sqrt(std::max(variance, 1e-12));
  test.p = std::min(1.0, std::erfc(z / std::sqrt(2.0)));
  return test;
}

PairedComparison compare_methods(std::span<const QueryRow> a, std::span<const QueryRow> b, const EvaluateSettings& protocol,
                                 int resamples, std::uint64_t seed) {
  std::map<std::int64_t, const QueryRow*> of_query;
  for (const QueryRow& row : b) of_query.emplace(row.query, &row);
  Rows in_a, in_b;
  for (const QueryRow& row : a) {
    const auto other = of_query.find(row.query);
    if (other == of_query.end()) continue;
    in_a.push_back(row);
    in_b.push_back(*other->second);
  }
  PairedComparison c;
  c.queries = in_a.size();
  const auto succeeds_3d = [&](const QueryRow& row) { return is_success(row, protocol, true); };
  c.recall_at_1 = by_rows(in_a, in_b, [](const QueryRow& row) { return row.positive; });
  c.r50_3d = by_rows(in_a, in_b, succeeds_3d);
  c.sr_2d = by_rows(in_a, in_b, [&](const QueryRow& row) { return row.positive && is_success(row, protocol, false); });
  c.sr_3d = by_rows(in_a, in_b, [&](const QueryRow& row) { return row.positive && succeeds_3d(row); });
  std::vector<double> position_a, position_b, rotation_a, rotation_b;
  for (std::size_t i = 0; i < in_a.size(); ++i) {
    if (!in_a[i].positive || !in_b[i].positive || !succeeds_3d(in_a[i]) || !succeeds_3d(in_b[i])) continue;
    position_a.push_back(in_a[i].error.spatial_m());
    position_b.push_back(in_b[i].error.spatial_m());
    rotation_a.push_back(in_a[i].error.rotation_deg());
    rotation_b.push_back(in_b[i].error.rotation_deg());
  }
  c.common_successes = position_a.size();
  c.position_m = wilcoxon_signed_rank(position_a, position_b);
  c.rotation_deg = wilcoxon_signed_rank(rotation_a, rotation_b);
  c.differences = bootstrap(in_a, in_b, protocol, resamples, seed);
  return c;
}

}  // namespace stemwise::treeloc
