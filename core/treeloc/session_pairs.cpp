#include "core/treeloc/session_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace stemwise::treeloc {

Stability stability_of(std::span<const double> values) {
  constexpr double epsilon = 1e-6;
  Stability s;
  if (values.empty()) return s;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) s.mean += v / n;
  for (const double v : values) s.sd += (v - s.mean) * (v - s.mean) / n;
  s.sd = std::sqrt(s.sd);
  s.stability = std::log(std::max(s.mean, epsilon) / (s.sd + epsilon));
  return s;
}

AtThreshold at_threshold(std::span<const QueryRow> rows, double threshold) {
  AtThreshold at;
  double true_positive = 0.0, positives = 0.0;
  for (const QueryRow& row : rows) {
    positives += row.positive ? 1.0 : 0.0;
    if (!row.found() || row.score < threshold) continue;
    ++at.accepted;
    if (row.positive) true_positive += 1.0;
    if (!row.positive) ++at.wrong;
  }
  if (at.accepted > 0) at.precision = true_positive / at.accepted;
  if (positives > 0.0) at.recall = true_positive / positives;
  if (at.precision + at.recall > 0.0) at.f1 = 2.0 * at.precision * at.recall / (at.precision + at.recall);
  return at;
}

double best_f1_threshold(std::span<const QueryRow> rows, int thresholds) {
  double best = -1.0, chosen = 0.0;
  for (int k = 0; k < thresholds; ++k) {
    const double threshold = static_cast<double>(k) / (thresholds - 1);
    const double f1 = at_threshold(rows, threshold).f1;
    if (f1 > best) best = f1, chosen = threshold;
  }
  return chosen;
}

std::vector<ThresholdTransfer> transfer_thresholds(std::span<const Evaluation> evaluations, int thresholds) {
  std::vector<ThresholdTransfer> transfers;
  if (evaluations.size() < 2) return transfers;
  const auto others = static_cast<double>(evaluations.size() - 1);
  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    ThresholdTransfer t{i, best_f1_threshold(evaluations[i].rows, thresholds), 0.0, 0.0, 1.0, 0.0, 0.0};
    t.f1_there = at_threshold(evaluations[i].rows, t.threshold).f1;
    for (std::size_t k = 0; k < evaluations.size(); ++k) {
      if (k == i) continue;
      const AtThreshold there = at_threshold(evaluations[k].rows, t.threshold);
      t.mean_f1_elsewhere += there.f1 / others;
      t.worst_f1_elsewhere = std::min(t.worst_f1_elsewhere, there.f1);
      t.mean_precision_elsewhere += there.precision / others;
      t.mean_recall_elsewhere += there.recall / others;
    }
    transfers.push_back(t);
  }
  return transfers;
}

}  // namespace stemwise::treeloc
