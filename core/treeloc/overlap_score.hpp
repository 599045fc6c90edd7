#pragma once
#include <cstddef>
#include <string>

#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// |M| / (|Tq| + |Tc| - |M|) * exp(-|t|^2 / sigma_t^2) (eq. 15); accepted above 0.2.
double overlap_score(int pairs, std::size_t query_trees, std::size_t candidate_trees, double displacement_m,
                     const OverlapScoreSettings& settings);

}  // namespace stemwise::treeloc
