#pragma once
#include <string>

#include "core/base/field.hpp"

namespace stemwise::treeloc {

/// How verified scenes are scored and chosen (method.md, sections 8 and 12).
struct VerifySettings {
  double strong_share = 0.7;
  double propagate_radius_m = 6.0;
  int propagate_most = 24;
  double penalty_m = 5.0;
  int min_pairs = 3;
  Fields fields(const std::string& prefix);
};

/// |M| / (|Tq| + |Tc| - |M|) * exp(-|t| / penalty): the default method's form of eq. 12. A match is accepted from 0.09 on,
/// for all forests: scenes with nothing within 30 m stay below.
double overlap_score_linear(int pairs, std::size_t query_trees, std::size_t candidate_trees, double displacement_m,
                            double penalty_m);
inline constexpr double stemwise_acceptance_score = 0.09;

}  // namespace stemwise::treeloc
