#pragma once
#include <string>

#include "core/survey/chart_models.hpp"
#include "core/treeloc/evaluate.hpp"

namespace stemwise {

// Charts of an evaluation. `title` says what was evaluated: "venman-03 in venman-04, stemwise".

/// Precision against recall over the sweep of thresholds, with the method's fixed threshold marked.
ChartModel precision_recall_chart(const treeloc::Evaluation& evaluation, const std::string& title);
/// Boxes of the absolute errors in x, y, z over the successes: quartiles, whiskers from the 5 to the 95 % quantile.
ChartModel position_error_chart(const treeloc::Evaluation& evaluation, const std::string& title);
/// The same of roll, pitch and yaw.
ChartModel rotation_error_chart(const treeloc::Evaluation& evaluation, const std::string& title);
/// Time from retrieval to pose, query after query.
ChartModel query_time_chart(const treeloc::Evaluation& evaluation, const std::string& title);

}  // namespace stemwise
