#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/run_program.hpp"

// What cannot be meant is refused before any work: exit code 2, and a sentence that names the option (cli.md).
namespace stemwise::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Words = std::vector<std::string>;

void expect_refused(const Words& arguments, const std::string& named) {
  const ProgramRun run = run_stemwise(arguments);
  std::string line;
  for (const std::string& word : arguments) line += word + " ";
  EXPECT_EQ(run.code, 2) << line << run.err;
  EXPECT_THAT(run.err, HasSubstr(named)) << line;
  EXPECT_EQ(run.err.find("internal error"), std::string::npos) << line << run.err;
  EXPECT_EQ(run.err.find("column"), std::string::npos) << line << run.err;
}

class Usage : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_stemwise({"simulate", "-o", folder_ / "s", "--stems", "80", "--years", "2015,2019", "--quiet"}).code, 0);
    ASSERT_EQ(run_stemwise({"align", a_, b_, "-o", project_, "--quiet"}).code, 0);
  }
  Folder folder_;
  std::string a_ = folder_ / "s/2015.csv", b_ = folder_ / "s/2019.csv", project_ = folder_ / "p.gpkg";
};

TEST_F(Usage, ASuffixThatNamesNoFormatIsRefusedByEveryCommand) {
  for (const char* name : {"o.docx", "o", ""}) {
    expect_refused({"report", project_, "-o", name[0] == 0 ? "" : folder_ / name}, "-o");
    expect_refused({"export", project_, "-o", name[0] == 0 ? "" : folder_ / name}, "-o");
    expect_refused({"align", a_, b_, "-o", name[0] == 0 ? "" : folder_ / name}, "-o");
  }
  expect_refused({"convert", a_, "-o", folder_ / "o.docx"}, "-o");
  expect_refused({"convert", a_, "-o", ""}, "-o");
  expect_refused({"report", project_, "-o", folder_ / "o.gpx"}, "-o");
}

TEST_F(Usage, NumbersThatCannotBeMeantAreRefused) {
  const std::string out = folder_ / "new";
  expect_refused({"simulate", "-o", out, "--false", "2"}, "false_stems");
  expect_refused({"simulate", "-o", out, "--yaw-deg", "nan"}, "yaw_deg");
  expect_refused({"simulate", "-o", out, "--seed", "99999999999999999999999"}, "--seed");
  expect_refused({"simulate", "-o", out, "--set", "simulate.drop=nan"}, "simulate.drop");
  expect_refused({"simulate", "-o", out, "--set", "simulate.foo=1"}, "simulate.foo");
  expect_refused({"align", a_, b_, "-o", folder_ / "q.gpkg", "--set", "lists.peaks=-5"}, "lists.peaks");
  expect_refused({"align", a_, b_, "-o", folder_ / "q.gpkg", "--set", "lists.cell_m=0"}, "lists.cell_m");
  for (const char* area : {"nan", "inf", "1e-300", "0", "-1"}) expect_refused({"report", project_, "-o", folder_ / "r.html", "--area-ha", area}, "--area-ha");
  EXPECT_FALSE(fs::exists(out));
  EXPECT_FALSE(fs::exists(folder_ / "q.gpkg"));
  EXPECT_FALSE(fs::exists(folder_ / "r.html"));
}

TEST_F(Usage, OptionsThatWouldChangeNothingOrBreakTheFileAreRefused) {
  for (const char* delimiter : {"\"", "a", "1", ".", "-"}) expect_refused({"export", project_, "-o", folder_ / "t.csv", "--delimiter", delimiter}, "--delimiter");
  expect_refused({"info", a_, "--sheet", "Trees"}, "--sheet");
  expect_refused({"info", a_, "--status", "K=gone"}, "--status");
  expect_refused({"simulate", "-o", folder_ / "new", "--resurvey", a_, "--frames"}, "--frames");
  EXPECT_EQ(run_stemwise({"export", project_, "-o", folder_ / "t.csv", "--delimiter", ";"}).code, 0);
}

TEST_F(Usage, AHintFileThatHintsAtNothingIsRefused) {
  const std::string pose = R"({"inventory": "2019", "pose": {"x_m": 0, "y_m": 0, "yaw_deg": 0, "radius_m": -1}})";
  for (const std::string& text : {std::string("[]"), pose}) {
    const ProgramRun run = run_stemwise({"align", a_, b_, "--reference", "2015", "-o", folder_ / "q.gpkg", "--hint", folder_.file("h.json", text)});
    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_THAT(run.err, HasSubstr(text == "[]" ? "holds no hint" : "radius_m"));
  }
}

TEST_F(Usage, TheFieldCheckSheetHasThePlaceOnTheEarthBehindTheLocalOne) {
  ASSERT_EQ(run_stemwise({"georeference", project_, "--anchor", "48.77214,9.16621,412.5,37", "--quiet"}).code, 0);
  ASSERT_EQ(run_stemwise({"report", project_, "-o", folder_ / "f.csv", "--field-check", "--quiet"}).code, 0);
  const std::string sheet = text_of(folder_ / "f.csv");
  EXPECT_THAT(sheet, HasSubstr("x m,y m,Species"));
  EXPECT_THAT(sheet, HasSubstr("x in WGS 84 / UTM zone 32N (EPSG:32632)"));
  EXPECT_THAT(sheet, HasSubstr(",48.76"));
}

}  // namespace
}  // namespace stemwise::testing
