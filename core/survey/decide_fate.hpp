#pragma once
#include <optional>
#include <vector>

#include "core/project/project_state.hpp"

namespace stemwise {

/// What deciding a fate needs of one survey, made once.
struct SurveyFootprint {
  InventoryId inventory;
  Polygon coverage_in_reference;   ///< empty when nothing is known: then everything counts as covered
  double position_noise_m = 0.0;
  double outline_doubt_m = 0.0;    ///< how far off the coverage's edge may lie from where the survey really ended
  double smallest_dbh_m = 0.0;     ///< the size from which on the survey took stems: its 2 % quantile
};

/// A step from one survey to the next one.
struct SurveyStep {
  const SurveyFootprint* from = nullptr;
  const SurveyFootprint* to = nullptr;
  double most_growth_m = 0.0;      ///< what a stem can have grown in between (95 % quantile of the matched, and error)
};

/// A tree at that step: where it is, what was seen.
struct TreeAtStep {
  Eigen::Vector2d position_in_reference_m = Eigen::Vector2d::Zero();
  bool seen_from = false;
  bool seen_to = false;
  bool seen_earlier = false;       ///< before `from`
  bool seen_later = false;         ///< after `to`
  StemStatus code_in_to = StemStatus::unknown;   ///< what the field crew wrote in `to`
  StemStatus code_before = StemStatus::unknown;  ///< at its last sighting up to `from`
  std::optional<double> dbh_in_to_m;
  std::optional<Fate> by_hand;
};

/// Product.md, item 5: survivor, ingrowth, missed earlier, missing inside coverage, outside coverage, unresolved; dead and
/// removed only where a person or a field code says so.
Fate decide_fate(const SurveyStep& step, const TreeAtStep& tree);

}  // namespace stemwise
