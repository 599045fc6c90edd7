#pragma once
#include "core/survey/report_model.hpp"
#include "io/report/drawing.hpp"

namespace stemwise {

/// Histogram of DBH change between two surveys: the 20-80 % band shaded, the median marked. Needs at least one change.
Drawing draw_change_histogram(const ReportModel& model, const ReportGrowth& growth);
/// Living stems per DBH class, one bar per survey.
Drawing draw_dbh_classes(const ReportModel& model);
/// Every merged tree at DBH scale, coloured by fate, with the coverage of the last two surveys and a scale bar.
Drawing draw_fate_map(const ReportModel& model);

}  // namespace stemwise
