#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/treeloc/evaluate.hpp"

namespace stemwise::treeloc {

// Many evaluations together: what the paper says of session pairs (method.md, section 10; the paper's section IV-D).

/// Mean, standard deviation (of the sample of pairs, n in the denominator) and the paper's stability
/// S = log(mean / (standard deviation + eps)), natural logarithm, eps 1e-6: larger is steadier.
struct Stability {
  double mean = 0.0;
  double sd = 0.0;
  double stability = 0.0;
};
Stability stability_of(std::span<const double> values);

/// What one threshold does on an evaluation: accepted rows are positives by claim.
struct AtThreshold {
  double precision = 1.0, recall = 0.0, f1 = 0.0;
  int accepted = 0, wrong = 0;  ///< wrong: accepted, but no positive
};
AtThreshold at_threshold(std::span<const QueryRow> rows, double threshold);

/// The threshold of the sweep with the best F1 (the lowest of several).
double best_f1_threshold(std::span<const QueryRow> rows, int thresholds);

/// A threshold chosen on one evaluation and used on the others.
struct ThresholdTransfer {
  std::size_t chosen_on = 0;
  double threshold = 0.0;
  double f1_there = 0.0;
  double mean_f1_elsewhere = 0.0, worst_f1_elsewhere = 0.0;
  double mean_precision_elsewhere = 1.0, mean_recall_elsewhere = 0.0;
};
std::vector<ThresholdTransfer> transfer_thresholds(std::span<const Evaluation> evaluations, int thresholds);

}  // namespace stemwise::treeloc
