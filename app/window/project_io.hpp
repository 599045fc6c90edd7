#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/jobs/progress.hpp"
#include "core/project/project_state.hpp"
#include "core/survey/tables.hpp"
#include "io/project_stamp.hpp"
#include "io/report/document.hpp"
#include "ui/requests.hpp"

namespace stemwise {

// What jobs of the window do with files: the same code as the command line's, on values only.

struct ReadSurvey {
  std::string path;
  Result<Inventory> inventory;  ///< with what was to say about it
};
using ReadSurveys = std::vector<ReadSurvey>;
/// The simulated forest of the demo, surveyed in three years.
ReadSurveys make_demo(const Progress& progress);

struct ReadProject {
  Result<ProjectState> state;
  ProjectStamp stamp;  ///< of the file, from before it was read
};
ReadProject read_project_file(const std::string& path);

struct SavedProject {
  Result<ProjectStamp> written;
  std::optional<ProjectStamp> changed_to;  ///< what stopped it: the file holds this by now, and not what was known of it
  std::size_t edits_there = 0;             ///< of the file's edit log that `state` does not have
};
/// `known`: as for write_project.
SavedProject write_project_file(const std::string& path, const ProjectState& state, const std::optional<ProjectStamp>& known);
Result<Done> write_export(const ProjectState& state, const ui::request::Export& what);
/// .pdf, .html, .csv, .xlsx, or waypoints as .gpx.
Result<Done> write_field_check(const ProjectState& state, const ui::request::WriteFieldCheck& what);
Result<Done> write_growth_report(const ProjectState& state, const ui::request::WriteReport& what);
/// `area_ha` 0: that of the coverage.
ReportDocument growth_report(const ProjectState& state, const Tables& tables, double area_ha);
ReportDocument field_check_sheet(const ProjectState& state, const Tables& tables, int most, bool for_print);

}  // namespace stemwise
