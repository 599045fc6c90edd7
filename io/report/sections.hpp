#pragma once
#include "core/survey/report_model.hpp"
#include "io/report/document.hpp"

namespace stemwise {

/// What the stock became between two surveys: increment, components, by species and by DBH class.
ReportSection change_section(const ReportModel& model);
/// DBH growth of the stand, of each species and of each DBH class, with intervals.
ReportSection interval_section(const ReportModel& model);
/// How values were merged, where the surveys contradict each other, which ground was seen too seldom.
ReportSection merge_section(const ReportModel& model);
/// What the chosen rules flag, what the other packs would flag, and every flagged tree.
ReportSection flag_section(const ReportModel& model);
/// How the figures came about: method, georeference with its residuals, settings and seed.
ReportSection method_section(const ReportModel& model, const std::string& software);
/// What the words and columns of this report and of the exports mean.
ReportSection dictionary_section();

}  // namespace stemwise
