#pragma once
#include <cstddef>
#include <string>

#include "core/base/field.hpp"

namespace stemwise::treeloc {

/// The published overlap score (method.md, section 8).
struct OverlapScoreSettings {
  bool penalty = true;
  double sigma_t_m = 5.0;
  Fields fields(const std::string& prefix);
};

/// |M| / (|Tq| + |Tc| - |M|) * exp(-|t|^2 / sigma_t^2) (eq. 15); accepted above 0.2.
double overlap_score(int pairs, std::size_t query_trees, std::size_t candidate_trees, double displacement_m,
                     const OverlapScoreSettings& settings);

}  // namespace stemwise::treeloc
