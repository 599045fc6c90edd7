#include "app/window/project_io.hpp"

#include "core/simulate/simulate_forest.hpp"
#include "core/survey/field_check.hpp"
#include "core/survey/report_model.hpp"
#include "io/export_layer.hpp"
#include "io/project_file.hpp"
#include "io/report/field_check.hpp"
#include "io/report/write_report.hpp"

namespace stemwise {

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

Result<ProjectState> read_project_file(const std::string& path) {
  return read_project(path);
}

Result<Done> write_project_file(const std::string& path, const ProjectState& state) {
  return write_project(state, path);
}

Result<Done> write_export(const ProjectState& state, const ui::request::Export& what) {
  ExportOptions options;
  options.layer = layer_kind_from(what.layer);
  if (what.epsg != 0) options.epsg = what.epsg;
  options.decimal_comma = what.decimal_comma;
  if (what.semicolon) options.delimiter = ';';
  return export_layer(state, what.path, options);
}

Result<Done> write_growth_report(const ProjectState& state, const ui::request::WriteReport& what) {
  ReportOptions options;
  if (what.area_ha > 0.0) options.area_ha = what.area_ha;
  const ReportModel model = make_report_model(state, derive_tables(state), options);
  return write_report(what.path, make_report_document(model, std::string("Stemwise ") + STEMWISE_VERSION));
}

Result<Done> write_field_check(const ProjectState& state, const ui::request::WriteFieldCheck& what) {
  const std::string software = std::string("Stemwise ") + STEMWISE_VERSION;
  const FieldCheck check = make_field_check(state, derive_tables(state), static_cast<std::size_t>(what.most));
  if (what.path.ends_with(".gpx")) return write_field_check_gpx(what.path, check, state.georeference, software);
  const bool for_print = what.path.ends_with(".pdf") || what.path.ends_with(".html");
  return write_report(what.path, make_field_check_document(check, state, software, for_print));
}

}  // namespace stemwise
