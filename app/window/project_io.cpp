#include "app/window/project_io.hpp"

#include <algorithm>

#include "core/simulate/simulate_forest.hpp"
#include "core/survey/field_check.hpp"
#include "core/survey/report_model.hpp"
#include "io/export_layer.hpp"
#include "io/project_file.hpp"
#include "io/report/field_check.hpp"
#include "io/report/write_report.hpp"

namespace stemwise {
namespace {

std::size_t count_unknown_edits(const std::vector<EditLogEntry>& there, const std::vector<EditLogEntry>& here) {
  return static_cast<std::size_t>(std::count_if(there.begin(), there.end(), [&](const EditLogEntry& edit) { return std::find(here.begin(), here.end(), edit) == here.end(); }));
}

std::string software() { return std::string("Stemwise ") + STEMWISE_VERSION; }

}  // namespace

ReadSurveys make_demo(const Progress& progress) {
  SimulateSettings settings;
  settings.seed = 7;
  SimulatedForest forest = simulate_forest(settings, progress);
  ReadSurveys demo;
  for (SimulatedSurvey& survey : forest.surveys) {
    survey.inventory.source.format = "simulated";
    demo.push_back({"", std::move(survey.inventory)});
  }
  return demo;
}

ReadProject read_project_file(const std::string& path) {
  ProjectStamp stamp = project_stamp(path);
  return {read_project(path), std::move(stamp)};
}

SavedProject write_project_file(const std::string& path, const ProjectState& state, const std::optional<ProjectStamp>& known) {
  SavedProject saved{write_project(state, path, known), std::nullopt};
  if (saved.written || !known || !is_changed_since(*known, path)) return saved;
  saved.changed_to = project_stamp(path);
  if (const Result<ProjectState> there = read_project(path)) saved.edits_there = count_unknown_edits(there->edit_log, state.edit_log);
  return saved;
}

Result<Done> write_export(const ProjectState& state, const ui::request::Export& what) {
  ExportOptions options;
  options.layer = layer_kind_from(what.layer);
  if (what.epsg != 0) options.epsg = what.epsg;
  options.decimal_comma = what.decimal_comma;
  if (what.semicolon) options.delimiter = ';';
  return export_layer(state, what.path, options);
}

ReportDocument growth_report(const ProjectState& state, const Tables& tables, double area_ha) {
  ReportOptions options;
  if (area_ha > 0.0) options.area_ha = area_ha;
  return make_report_document(make_report_model(state, tables, options), software());
}

ReportDocument field_check_sheet(const ProjectState& state, const Tables& tables, int most, bool for_print) {
  return make_field_check_document(make_field_check(state, tables, static_cast<std::size_t>(most)), state, software(), for_print);
}

Result<Done> write_growth_report(const ProjectState& state, const ui::request::WriteReport& what) {
  return write_report(what.path, growth_report(state, derive_tables(state), what.area_ha));
}

Result<Done> write_field_check(const ProjectState& state, const ui::request::WriteFieldCheck& what) {
  const Tables tables = derive_tables(state);
  if (what.path.ends_with(".gpx")) {
    return write_field_check_gpx(what.path, make_field_check(state, tables, static_cast<std::size_t>(what.most)), state.georeference, software());
  }
  const bool for_print = what.path.ends_with(".pdf") || what.path.ends_with(".html");
  return write_report(what.path, field_check_sheet(state, tables, what.most, for_print));
}

}  // namespace stemwise
