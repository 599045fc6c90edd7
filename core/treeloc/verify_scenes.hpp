#pragma once
#include <string>

#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// |M| / (|Tq| + |Tc| - |M|) * exp(-|t| / penalty): the default method's form of eq. 12. A match is accepted from 0.10 on,
/// for all forests: chance reached 0.077 where nothing lay within 30 m, and 0.091 once among 4,000 queries with something nearby.
double overlap_score_linear(int pairs, std::size_t query_trees, std::size_t candidate_trees, double displacement_m,
                            double penalty_m);
inline constexpr double stemwise_acceptance_score = 0.10;

}  // namespace stemwise::treeloc
