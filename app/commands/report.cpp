#include <algorithm>

#include "app/commands/open_project.hpp"
#include "app/commands/project_commands.hpp"
#include "core/survey/report_model.hpp"
#include "core/survey/tables.hpp"
#include "io/report/write_report.hpp"

namespace stemwise {

ExitCode run_report(const ReportCommandOptions& options, Session& session) {
  if (options.area_ha && *options.area_ha <= 0.0) {
    session.console.error("--area-ha must be more than 0");
    return ExitCode::usage;
  }
  const std::optional<Project> project = open_project(options.project, session);
  if (!project) return ExitCode::unusable_input;
  const Tables tables = derive_tables(project->state());
  if (tables.inventories.empty()) {
    session.console.error(options.project + ": no survey of this project has been aligned, so there is nothing to report");
    return ExitCode::failed;
  }
  session.progress().check();
  const ReportModel model = make_report_model(project->state(), tables, {options.area_ha, options.class_width_cm});
  const Result<Done> written = write_report(options.output, make_report_document(model, std::string("Stemwise ") + STEMWISE_VERSION));
  session.console.issues(written.issues);
  return written ? ExitCode::done : ExitCode::failed;
}

}  // namespace stemwise
