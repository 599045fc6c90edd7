#pragma once
#include "core/survey/report_model.hpp"
#include "io/report/document.hpp"

namespace stemwise {

/// What the chosen rules flag, what the other packs would flag, and every flagged tree.
ReportSection flag_section(const ReportModel& model);
/// How the figures came about: method, georeference with its residuals, settings and seed.
ReportSection method_section(const ReportModel& model, const std::string& software);
/// What the words and columns of this report and of the exports mean.
ReportSection dictionary_section();

}  // namespace stemwise
