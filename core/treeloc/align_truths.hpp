#pragma once
#include <vector>

#include "core/treeloc/evaluate.hpp"

namespace stemwise::treeloc {

/// Fits the one SE(3) that best explains the estimates as "the truth, seen in the other session's frame" (method.md,
/// section 10: the sessions' truths are about 0.45 m off each other), robustly, and recomputes the rows' errors against the
/// truth so moved. Gives that transform, map from query survey.
RigidTransform align_truths(std::vector<QueryRow>& rows);
/// Errors against the truth moved by such a transform.
void compare_with_moved_truth(std::vector<QueryRow>& rows, const RigidTransform& map_from_query_survey);

}  // namespace stemwise::treeloc
