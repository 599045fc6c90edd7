#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>
#include <vector>

#include "tests/app/run_program.hpp"

// What others' programs and the formats' own rules say of everything that is written (issue 5).
namespace stemwise::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

struct Ran {
  int code = -1;
  std::string out;
};

Ran run(const std::string& command) {
  Ran ran;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return ran;
  std::array<char, 4096> part{};
  while (const std::size_t n = fread(part.data(), 1, part.size(), pipe)) ran.out.append(part.data(), n);
  ran.code = pclose(pipe);
  return ran;
}

bool is_installed(const std::string& program) { return run("command -v " + program).code == 0; }

struct WordBox {
  double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;
  std::string word;
};

/// The words of a page and where they stand, by pdftotext.
std::vector<WordBox> words_of_page(const std::string& pdf, int page) {
  const std::string number = std::to_string(page);
  const Ran ran = run("pdftotext -bbox -f " + number + " -l " + number + " '" + pdf + "' -");
  static const std::regex word(R"re(<word xMin="([0-9.]+)" yMin="([0-9.]+)" xMax="([0-9.]+)" yMax="([0-9.]+)">([^<]*)<)re");
  std::vector<WordBox> boxes;
  for (std::sregex_iterator it(ran.out.begin(), ran.out.end(), word), end; it != end; ++it)
    boxes.push_back({std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), std::stod((*it)[4]), (*it)[5]});
  return boxes;
}

class Outputs : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_stemwise({"simulate", "-o", folder_ / "s", "--stems", "150", "--seed", "3", "--quiet"}).code, 0);
    ASSERT_EQ(run_stemwise({"align", folder_ / "s/2015.csv", folder_ / "s/2019.csv", folder_ / "s/2023.csv", "-o", project_, "--quiet"}).code, 0);
    ASSERT_EQ(run_stemwise({"georeference", project_, "--anchor", "48.77214,9.16621,412.5,37", "--quiet"}).code, 0);
  }
  std::string written(const std::vector<std::string>& arguments, const std::string& name) {
    std::vector<std::string> all{arguments.front(), project_, "-o", folder_ / name};
    all.insert(all.end(), arguments.begin() + 1, arguments.end());
    const ProgramRun done = run_stemwise(all);
    EXPECT_EQ(done.code, 0) << name << ": " << done.err;
    return folder_ / name;
  }
  Folder folder_;
  std::string project_ = folder_ / "project.gpkg";
};

TEST_F(Outputs, EveryPdfHasTextThatPdftotextReadsOnEveryPage) {
  if (!is_installed("pdftotext")) GTEST_SKIP() << "pdftotext is not installed";
  const Ran report = run("pdftotext -layout '" + written({"report", "--rules", "ctfs"}, "r.pdf") + "' -");
  EXPECT_EQ(report.code, 0) << report.out;
  for (const char* title : {"Growth report", "Surveys and alignment quality", "What became of the trees", "DBH change of matched stems", "Growth of the stand, with its uncertainty", "Growth by species",
                            "Growth by DBH class", "Components of change", "Periodic annual increment", "By DBH class", "Stand structure", "Plausibility of growth", "New and missing stems",
                            "The merged inventory", "Method, settings and seed", "Data dictionary"})
    EXPECT_THAT(report.out, HasSubstr(title));
  const auto pages = static_cast<int>(std::count(report.out.begin(), report.out.end(), '\f'));
  EXPECT_THAT(report.out, HasSubstr(std::to_string(pages) + " of " + std::to_string(pages))) << "every page is numbered";
  const Ran check = run("pdftotext '" + written({"report", "--field-check"}, "check.pdf") + "' -");
  EXPECT_EQ(check.code, 0) << check.out;
  EXPECT_THAT(check.out, HasSubstr("T-0"));
}

TEST_F(Outputs, OgrinfoOpensEveryExportAndCountsItsFeatures) {
  if (!is_installed("ogrinfo")) GTEST_SKIP() << "ogrinfo is not installed";
  const json trees = json::parse(text_of(written({"export"}, "t.geojson")));
  const std::string count = "Feature Count: " + std::to_string(trees["features"].size());
  for (const char* name : {"t.gpkg", "t.shp", "t.geojson", "t.fgb", "t.kml", "t.dxf", "t.csv", "t.xlsx"}) {
    const Ran seen = run("ogrinfo -ro -so -al '" + written({"export", "--layer", "trees"}, name) + "'");
    EXPECT_EQ(seen.code, 0) << name << ": " << seen.out;
    EXPECT_EQ(seen.out.find("ERROR"), std::string::npos) << name << ": " << seen.out;
    if (std::string(name) == "t.dxf") continue;  // its texts are features too
    EXPECT_THAT(seen.out, HasSubstr(count)) << name;
  }
  for (const char* layer : {"observations", "matches", "links", "inventories", "coverage"}) {
    const Ran seen = run("ogrinfo -ro -so -al '" + written({"export", "--layer", layer}, std::string(layer) + ".gpkg") + "'");
    EXPECT_EQ(seen.code, 0) << layer << ": " << seen.out;
    EXPECT_THAT(seen.out, HasSubstr("Feature Count: ")) << layer;
  }
  EXPECT_EQ(run("ogrinfo -ro -so -al '" + written({"report"}, "report.xlsx") + "'").code, 0);
}

/// Every ring is closed and goes round as RFC 7946 asks: the outer one to the left.
void expect_valid_polygon(const json& rings) {
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const json& ring = rings[r];
    ASSERT_GE(ring.size(), 4U);
    EXPECT_EQ(ring.front(), ring.back());
    double twice = 0.0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      const double ax = ring[i][0].get<double>() - ring[0][0].get<double>(), ay = ring[i][1].get<double>() - ring[0][1].get<double>();
      const double bx = ring[i + 1][0].get<double>() - ring[0][0].get<double>(), by = ring[i + 1][1].get<double>() - ring[0][1].get<double>();
      twice += ax * by - bx * ay;
    }
    EXPECT_EQ(twice > 0.0, r == 0) << "ring " << r;
  }
}

void expect_positions(const json& coordinates) {
  if (!coordinates.empty() && coordinates.front().is_array()) {
    for (const json& part : coordinates) expect_positions(part);
    return;
  }
  ASSERT_GE(coordinates.size(), 2U);
  ASSERT_LE(coordinates.size(), 3U);
  EXPECT_LE(std::abs(coordinates[0].get<double>()), 180.0);
  EXPECT_LE(std::abs(coordinates[1].get<double>()), 90.0);
}

TEST_F(Outputs, GeoJsonKeepsTheRulesOfRfc7946) {
  for (const char* layer : {"trees", "links", "coverage", "observations"}) {
    SCOPED_TRACE(layer);
    const json collection = json::parse(text_of(written({"export", "--layer", layer}, std::string(layer) + ".geojson")));
    EXPECT_EQ(collection["type"], "FeatureCollection");
    EXPECT_FALSE(collection.contains("crs")) << "always WGS 84";
    ASSERT_TRUE(collection["features"].is_array());
    EXPECT_GT(collection["features"].size(), 0U);
    for (const json& feature : collection["features"]) {
      EXPECT_EQ(feature["type"], "Feature");
      ASSERT_TRUE(feature.contains("geometry") && feature.contains("properties"));
      EXPECT_TRUE(feature["properties"].is_object());
      if (feature["geometry"].is_null()) continue;
      expect_positions(feature["geometry"]["coordinates"]);
      if (feature["geometry"]["type"] == "Polygon") expect_valid_polygon(feature["geometry"]["coordinates"]);
    }
  }
}

TEST_F(Outputs, GpxKeepsTheRulesOfItsSchema) {
  const std::string gpx = text_of(written({"report", "--field-check"}, "check.gpx"));
  EXPECT_TRUE(gpx.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>"));
  EXPECT_TRUE(std::regex_search(gpx, std::regex("<gpx version=\"1\\.1\" creator=\"[^\"]+\" xmlns=\"http://www\\.topografix\\.com/GPX/1/1\"")));
  EXPECT_TRUE(std::regex_search(gpx, std::regex("<metadata><name>[^<]*</name><desc>[^<]*</desc><time>\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ</time></metadata>"))) << "in the schema's order";
  // wptType: ele, time, ..., name, cmt, desc, src, link, sym, type: in this order, each at most once
  const std::regex point("<wpt lat=\"(-?\\d+\\.\\d+)\" lon=\"(-?\\d+\\.\\d+)\">(<ele>-?\\d+(\\.\\d+)?</ele>)?<name>[^<]*</name><desc>[^<]*</desc><sym>[^<]*</sym></wpt>");
  int points = 0;
  for (std::sregex_iterator at(gpx.begin(), gpx.end(), point), end; at != end; ++at, ++points) {
    EXPECT_NEAR(std::stod((*at)[1]), 48.77, 0.1);
    EXPECT_NEAR(std::stod((*at)[2]), 9.17, 0.1);
  }
  const std::regex any_point("<wpt ");
  EXPECT_EQ(points, std::distance(std::sregex_iterator(gpx.begin(), gpx.end(), any_point), std::sregex_iterator())) << "every point keeps to the schema";
  EXPECT_GT(points, 0);
  if (!is_installed("ogrinfo")) GTEST_SKIP() << "ogrinfo is not installed";
  EXPECT_THAT(run("ogrinfo -ro -so '" + (folder_ / "check.gpx") + "' waypoints").out, HasSubstr("Feature Count: " + std::to_string(points)));
}

TEST(LongNames, NothingOnTheCoverIsPrintedOverAnythingElse) {
  if (!is_installed("pdftotext")) GTEST_SKIP() << "pdftotext is not installed";
  const Folder folder;
  ASSERT_EQ(run_stemwise({"simulate", "-o", folder / "s", "--stems", "120", "--quiet"}).code, 0);
  std::vector<std::string> arguments{"align"};
  for (const char* year : {"2015", "2019", "2023"}) {
    arguments.push_back(folder / ("PRF025_Field_original_of_the_northern_compartment_with_a_name_that_wraps_" + std::string(year) + ".csv"));
    std::filesystem::rename(folder / ("s/" + std::string(year) + ".csv"), arguments.back());
  }
  arguments.insert(arguments.end(), {"-o", folder / "p.gpkg", "--quiet"});
  ASSERT_EQ(run_stemwise(arguments).code, 0);
  ASSERT_EQ(run_stemwise({"report", folder / "p.gpkg", "-o", folder / "r.pdf", "--quiet"}).code, 0);
  const std::vector<WordBox> words = words_of_page(folder / "r.pdf", 1);
  ASSERT_GT(words.size(), 30U);
  constexpr double slack_pt = 2.5;  // boxes are a line high, ink is less
  for (std::size_t i = 0; i < words.size(); ++i)
    for (std::size_t k = i + 1; k < words.size(); ++k) {
      const double w = std::min(words[i].x1, words[k].x1) - std::max(words[i].x0, words[k].x0), h = std::min(words[i].y1, words[k].y1) - std::max(words[i].y0, words[k].y0);
      EXPECT_FALSE(w > slack_pt && h > slack_pt) << words[i].word << " over " << words[k].word;
    }
}

}  // namespace
}  // namespace stemwise::testing
