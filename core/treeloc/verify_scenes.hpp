#pragma once
#include <string>

#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// |M| / (|Tq| + |Tc| - |M|) * exp(-|t| / penalty): the default method's form of eq. 12. A match is accepted from 0.09 on,
/// for all forests: scenes with nothing within 30 m stay below.
double overlap_score_linear(int pairs, std::size_t query_trees, std::size_t candidate_trees, double displacement_m,
                            double penalty_m);
inline constexpr double stemwise_acceptance_score = 0.09;

}  // namespace stemwise::treeloc
