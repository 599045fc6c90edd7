#pragma once
#include <span>
#include <vector>

#include "core/forest/frame_set.hpp"
#include "core/survey/associate_observations.hpp"
#include "core/survey/frame_observations.hpp"

namespace stemwise {

/// Weighted median, the lower one of two; 0 when empty.
struct Weighted {
  double value = 0.0;
  double weight = 0.0;
};
double weighted_median(std::vector<Weighted> values);

/// What all trees of a survey are summarised with.
struct SummaryContext {
  const FrameSet& frames;
  const FrameObservations& observations;
  std::span<const double> frame_weight;        ///< of positions
  std::span<const double> frame_height_weight; ///< of base heights
};

/// The stem that a group of observations is, in the survey's frame.
Stem summarise_tree(const TreeNode& tree, const SummaryContext& context);

}  // namespace stemwise
