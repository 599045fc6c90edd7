#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/treeloc/evaluate.hpp"

namespace stemwise::treeloc {

// Two methods on the same queries (the paper's appendix G).

/// Exact McNemar test: of the queries where only one of the two succeeds, is it always the same one? Two-sided, by the
/// binomial distribution with one half.
struct McNemar {
  int only_a = 0, only_b = 0;
  double p = 1.0;
};
McNemar exact_mcnemar(std::span<const char> success_a, std::span<const char> success_b);

/// Wilcoxon's signed-rank test, two-sided, zeros left out, ties with mean ranks. Exact for up to 50 pairs without ties, else
/// the normal approximation with corrections for ties and continuity.
struct Wilcoxon {
  int pairs = 0;              ///< that differ
  double median_difference = 0.0;  ///< a - b, of all pairs
  double rank_sum = 0.0;      ///< of the pairs where a is larger
  double p = 1.0;
};
Wilcoxon wilcoxon_signed_rank(std::span<const double> a, std::span<const double> b);

/// A figure of one method less that of the other, with the 2.5 and 97.5 percentiles over resampled queries.
struct BootstrapDifference {
  std::string figure;  ///< "recall_at_1", "mf1", "auc", "r50_3d", "sr_3d", "ate_m", "are_deg"
  double a = 0.0, b = 0.0;
  double difference = 0.0;
  double low = 0.0, high = 0.0;
};

struct PairedComparison {
  std::size_t queries = 0;           ///< that both have
  std::size_t common_successes = 0;  ///< pose within the limits and positive, in both
  McNemar recall_at_1, r50_3d, sr_2d, sr_3d;
  Wilcoxon position_m, rotation_deg;  ///< over the common successes
  std::vector<BootstrapDifference> differences;
};

/// Rows of the two methods, joined by query. Deterministic by `seed`.
PairedComparison compare_methods(std::span<const QueryRow> a, std::span<const QueryRow> b, const EvaluateSettings& protocol,
                                 int resamples, std::uint64_t seed);

}  // namespace stemwise::treeloc
