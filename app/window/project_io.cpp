#include "app/window/project_io.hpp"

#include <filesystem>

#include "core/simulate/simulate_forest.hpp"
#include "core/survey/build_global_inventory.hpp"
#include "core/survey/report_model.hpp"
#include "io/export_layer.hpp"
#include "io/project_file.hpp"
#include "io/read_inventory.hpp"
#include "io/report/write_report.hpp"

namespace stemwise {
namespace {

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

ReadSurveys read_surveys(const std::vector<std::string>& paths, const Progress& progress) {
  ReadSurveys read;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto share = [&](double k) { return (static_cast<double>(i) + k) / static_cast<double>(paths.size()); };
    progress.at(share(0.0), "Reading " + file_name(paths[i]));
    Result<Inventory> one = read_inventory(paths[i]);
    if (one) *one = with_global_stems(std::move(*one), {}, progress.stage(share(0.3), share(1.0)));
    read.push_back({paths[i], std::move(one)});
  }
  return read;
}

Result<Inventory> read_survey_in_unit(const std::string& path, const std::string& column, const std::string& unit, const Progress& progress) {
  progress.at(0.1, "Reading " + file_name(path));
  ReadOptions options;
  options.units[column] = unit;
  return read_inventory(path, options);
}

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

}  // namespace stemwise
