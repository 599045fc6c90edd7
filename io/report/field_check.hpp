#pragma once
#include <string>

#include "core/base/result.hpp"
#include "core/survey/field_check.hpp"
#include "io/report/document.hpp"

namespace stemwise {

/// The sheet to take outside: a row per doubtful tree with room for what is found there. `title`: the project's. For print a
/// bearing is one cell ("4.56 m at 268 from T-00012"); else distance and azimuth are columns of numbers, and behind them stand the
/// coordinates in the system of the georeference, where there is one.
ReportDocument make_field_check_document(const FieldCheck& check, const ProjectState& state, const std::string& software, bool for_print);

/// Waypoints (GPX 1.1), named by tree, described by what is doubtful and how to get there. Fails without a georeference.
Result<Done> write_field_check_gpx(const std::string& path, const FieldCheck& check, const Georeference& georeference, const std::string& software);

}  // namespace stemwise
