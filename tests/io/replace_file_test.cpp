#include "io/replace_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/survey/report_model.hpp"
#include "core/survey/tables.hpp"
#include "io/export_layer.hpp"
#include "io/project_file.hpp"
#include "io/report/document.hpp"
#include "io/report/write_report.hpp"
#include "io/write_inventory.hpp"
#include "tests/io/sample_project.hpp"

namespace stemwise {
namespace {

TEST(ReplaceFile, EveryWriterNamesTheFolderThatIsNotThere) {
  const std::string folder = (std::filesystem::path(testing::TempDir()) / ("nowhere-" + std::to_string(::getpid()))).string();
  const auto told = [&](const std::string& name, const Issues& issues) {
    ASSERT_FALSE(issues.empty()) << name;
    EXPECT_NE(to_string(issues.front()).find("the folder " + folder + " is not there"), std::string::npos) << to_string(issues.front());
  };
  const ProjectState state = sample_project();
  told("project", write_project(state, folder + "/p.gpkg").issues);
  ExportOptions options;
  options.layer = LayerKind::trees;
  for (const char* name : {"/t.gpkg", "/t.csv", "/t.xlsx", "/t.shp", "/t.geojson", "/t.kmz", "/t.dxf", "/t.fgb"}) told(name, export_layer(state, folder + name, options).issues);
  const ReportDocument document = make_report_document(make_report_model(state, derive_tables(state), {}), "Stemwise");
  for (const char* name : {"/r.html", "/r.pdf", "/r.csv", "/r.xlsx"}) told(name, write_report(folder + name, document).issues);
  told("inventory", write_inventory(folder + "/i.csv", *state.inventories.front()).issues);
}

}  // namespace
}  // namespace stemwise
