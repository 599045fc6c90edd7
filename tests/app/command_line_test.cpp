#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/run_program.hpp"

namespace stemwise::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(CommandLine, HelpAndVersionGoToStdoutAndSucceed) {
  const ProgramRun version = run_stemwise({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_THAT(version.out, HasSubstr("stemwise "));
  const ProgramRun help = run_stemwise({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.out, HasSubstr("Exit codes"));
  EXPECT_EQ(help.err, "");
}

TEST(CommandLine, EveryCommandHasHelpOfItsOwn) {
  for (const char* command : {"info", "convert", "align", "georeference", "merge", "export", "report", "snapshot", "evaluate", "simulate"}) {
    const ProgramRun run = run_stemwise({command, "--help"});
    EXPECT_EQ(run.code, 0) << command;
    EXPECT_THAT(run.out, HasSubstr("--threads")) << command;
  }
}

TEST(CommandLine, BadUsageIsExitCode2AndSaysWhereHelpIs) {
  const std::vector<std::vector<std::string>> wrong{{"nonsense"}, {"info"}, {"align", "one.csv", "-o", "p.gpkg"}, {"align", "a.csv", "b.csv"},
                                                    {"info", "a.csv", "--threads", "none"}, {"info", "a.csv", "--no-such-option"},
                                                    {"georeference", "p.gpkg"}, {"snapshot", "p.gpkg", "-o", "p.png", "--size", "big"}};
  for (const auto& arguments : wrong) {
    const ProgramRun run = run_stemwise(arguments);
    EXPECT_EQ(run.code, 2) << arguments.front() << ": " << run.err;
    EXPECT_THAT(run.err, HasSubstr("--help"));
  }
}

TEST(CommandLine, AnUnknownSettingIsBadUsageAndNamesTheNearestOne) {
  const Folder folder;
  const ProgramRun run = run_stemwise({"simulate", "-o", folder / "out", "--set", "simulate.stem=5"});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("simulate.stem"));
  EXPECT_FALSE(fs::exists(folder / "out"));
  EXPECT_EQ(run_stemwise({"simulate", "-o", folder / "out", "--set", "nonsense"}).code, 2);
}

TEST(CommandLine, ABrokenConfigIsRefused) {
  const Folder folder;
  const std::string config = folder.file("config.json", "[1, 2]");
  EXPECT_EQ(run_stemwise({"simulate", "-o", folder / "out", "--config", config}).code, 2);
  EXPECT_EQ(run_stemwise({"simulate", "-o", folder / "out", "--config", folder / "none.json"}).code, 2);
}

TEST(CommandLine, AnOverrideForAnInventoryThereIsNotIsBadUsage) {
  const Folder folder;
  const std::string csv = folder.file("2015.csv", "x,y,dbh\n1,2,30\n3,4,31\n");
  EXPECT_EQ(run_stemwise({"info", csv, "--map", "2019:x=x"}).code, 2);
  EXPECT_EQ(run_stemwise({"info", csv, "--date", "yesterday"}).code, 2);
}

struct BrokenInput {
  const char* name;
  const char* text;
};

TEST(BrokenInputs, WhatHasNoUsableRowIsExitCode3WithItsNameAndNothingWritten) {
  const std::vector<BrokenInput> broken{{"empty.csv", ""}, {"header.csv", "x,y,dbh\n"}, {"columns.csv", "name,colour\nfir,green\n"},
                                        {"words.csv", "x,y,dbh\na,b,c\nd,e,f\n"}, {"nan.csv", "x,y,dbh\nnan,nan,3\ninf,1,2\n"}};
  const Folder folder;
  const std::string good = folder.file("good.csv", "x,y,dbh\n1,2,30\n3,4,31\n5,6,20\n");
  for (const BrokenInput& input : broken) {
    const std::string path = folder.file(input.name, input.text);
    const ProgramRun info = run_stemwise({"info", path});
    EXPECT_EQ(info.code, 3) << input.name << ": " << info.err;
    EXPECT_THAT(info.err, HasSubstr(input.name));
    const ProgramRun align = run_stemwise({"align", good, path, "-o", folder / "project.gpkg", "--json", folder / "report.json"});
    EXPECT_EQ(align.code, 3) << input.name << ": " << align.err;
    EXPECT_FALSE(fs::exists(folder / "project.gpkg"));
    EXPECT_FALSE(fs::exists(folder / "report.json"));
  }
}

TEST(BrokenInputs, AFolderThatIsNoneAndOneWithoutTrajectoryAreExitCode3) {
  const Folder folder;
  fs::create_directories(folder.path() / "plain");
  fs::create_directories(folder.path() / "frames");
  folder.file("frames/TreeManagerState_0.csv", "location_x,location_y,dbh\n1,2,0.3\n");
  for (const char* name : {"plain", "frames", "missing"}) {
    const ProgramRun run = run_stemwise({"info", folder / name});
    EXPECT_EQ(run.code, 3) << name << ": " << run.err;
    EXPECT_THAT(run.err, HasSubstr(name));
  }
}

TEST(BrokenInputs, SomeBadRowsAreNamedByFileRowAndColumnAndTheRestIsRead) {
  const Folder folder;
  const std::string path = folder.file("mixed.csv", "id,x,y,dbh_cm\n1,1.0,2.0,30\n2,oops,2.0,31\n3,4.0,nan,20\n4,5.0,6.0,\n5,7.0,8.0,25\n");
  const ProgramRun run = run_stemwise({"info", path, "--json", folder / "info.json"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("mixed.csv, row 3, column x"));
  EXPECT_THAT(run.err, HasSubstr("mixed.csv, row 4, column y"));
  const auto json = nlohmann::json::parse(text_of(folder / "info.json"));
  EXPECT_EQ(json["inventories"][0]["stems"], 3);
}

TEST(BrokenInputs, TheWrongDelimiterIsExitCode3) {
  const Folder folder;
  const std::string path = folder.file("hash.csv", "x#y#dbh\n1#2#30\n3#4#31\n");
  EXPECT_EQ(run_stemwise({"info", path}).code, 3);
}

TEST(CommandLine, AnOutputThatCannotBeWrittenIsExitCode1) {
  const Folder folder;
  const std::string csv = folder.file("2015.csv", "x,y,dbh_cm\n1,2,30\n3,4,31\n5,6,20\n");
  EXPECT_EQ(run_stemwise({"convert", csv, "-o", folder / "no/such/out.csv"}).code, 1);
  EXPECT_EQ(run_stemwise({"align", csv, csv, "-o", folder / "no/such/p.gpkg"}).code, 1);
  EXPECT_EQ(run_stemwise({"info", csv, "--json", folder / "no/such/info.json"}).code, 1);
  EXPECT_FALSE(fs::exists(folder / "no"));
}

TEST(CommandLine, WhatIsNoProjectIsExitCode3) {
  const Folder folder;
  const std::string csv = folder.file("2015.csv", "x,y,dbh_cm\n1,2,30\n");
  EXPECT_EQ(run_stemwise({"report", csv, "-o", folder / "r.html"}).code, 3);
  EXPECT_EQ(run_stemwise({"merge", folder / "none.gpkg"}).code, 3);
  EXPECT_FALSE(fs::exists(folder / "r.html"));
}

TEST(Simulate, MakesTheSameBytesForTheSameSeedAndOthersForAnother) {
  const Folder folder;
  for (const char* name : {"a", "b"}) {
    ASSERT_EQ(run_stemwise({"simulate", "-o", folder / name, "--years", "2015,2019", "--stems", "80", "--seed", "7", "--quiet"}).code, 0);
  }
  ASSERT_EQ(run_stemwise({"simulate", "-o", folder / "c", "--years", "2015,2019", "--stems", "80", "--seed", "8", "--quiet"}).code, 0);
  for (const char* file : {"/2015.csv", "/2019.csv", "/truth/trees.csv", "/truth/poses.json"}) {
    EXPECT_EQ(text_of(folder / ("a" + std::string(file))), text_of(folder / ("b" + std::string(file)))) << file;
    EXPECT_NE(text_of(folder / ("a" + std::string(file))), text_of(folder / ("c" + std::string(file)))) << file;
  }
  EXPECT_THAT(text_of(folder / "a/2015.csv"), HasSubstr("id,x_m,y_m,z_m,dbh_cm,axis_x,axis_y,axis_z,species,status,date\n"));
}

TEST(Convert, WritesATableThatReadsBackAsTheSame) {
  const Folder folder;
  ASSERT_EQ(run_stemwise({"simulate", "-o", folder / "s", "--years", "2015", "--stems", "50", "--quiet"}).code, 0);
  ASSERT_EQ(run_stemwise({"convert", folder / "s/2015.csv", "-o", folder / "once.tsv", "--quiet"}).code, 0);
  ASSERT_EQ(run_stemwise({"convert", folder / "once.tsv", "-o", folder / "twice.csv", "--quiet"}).code, 0);
  EXPECT_EQ(text_of(folder / "twice.csv"), text_of(folder / "s/2015.csv"));
}

/// Three simulated surveys, aligned once for the tests below.
class SmallProject : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_stemwise({"simulate", "-o", folder_ / "s", "--stems", "150", "--seed", "3", "--quiet"}).code, 0);
    const ProgramRun run = align("project.gpkg", "report.json", {});
    ASSERT_EQ(run.code, 0) << run.err;
  }
  ProgramRun align(const std::string& project, const std::string& json, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"align", folder_ / "s/2015.csv", folder_ / "s/2019.csv", folder_ / "s/2023.csv", "-o", folder_ / project, "--json", folder_ / json, "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_stemwise(arguments, "SOURCE_DATE_EPOCH=1700000000");
  }
  Folder folder_;
};

TEST_F(SmallProject, AlignSaysInJsonWhatTheContractPromises) {
  const auto json = nlohmann::json::parse(text_of(folder_ / "report.json"));
  for (const char* key : {"reference", "seed", "inventories", "pairs", "trees", "growth", "timing_s"}) EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["groups"], nlohmann::json::parse(R"([["2015", "2019", "2023"]])"));
  EXPECT_TRUE(json["rejected_constraints"].empty()) << "bare lists have no trajectory";
  ASSERT_EQ(json["inventories"].size(), 3u);
  int aligned = 0;
  for (const auto& inventory : json["inventories"]) {
    for (const char* key : {"name", "date", "trees", "status", "reason", "T_reference_from_inventory", "observed", "overlap", "position_noise_m", "acceptance", "matched", "residual_rms_m"}) {
      EXPECT_TRUE(inventory.contains(key)) << key;
    }
    aligned += inventory["status"] == "aligned" ? 1 : 0;
  }
  EXPECT_EQ(aligned, 2);
  EXPECT_EQ(json["growth"].size(), 2u);
  EXPECT_GT(json["growth"][0]["n"], 50);
}

TEST_F(SmallProject, AlignGivesTheSameBytesAtAnyThreadCount) {
  ASSERT_EQ(align("one.gpkg", "one.json", {"--threads", "1"}).code, 0);
  ASSERT_EQ(align("two.gpkg", "two.json", {"--threads", "2"}).code, 0);
  auto one = nlohmann::json::parse(text_of(folder_ / "one.json")), two = nlohmann::json::parse(text_of(folder_ / "two.json"));
  one.erase("timing_s");
  two.erase("timing_s");
  EXPECT_EQ(one, two);
  EXPECT_EQ(text_of(folder_ / "one.gpkg"), text_of(folder_ / "two.gpkg"));
}

TEST_F(SmallProject, EveryResultIsWrittenFromTheProject) {
  const std::string project = folder_ / "project.gpkg";
  EXPECT_EQ(run_stemwise({"georeference", project, "--anchor", "48.77214,9.16621,412.5,37", "--quiet"}).code, 0);
  EXPECT_EQ(run_stemwise({"merge", project, "--policy", "newest", "--quiet"}).code, 0);
  for (const char* report : {"r.html", "r.pdf", "r.csv"}) {
    EXPECT_EQ(run_stemwise({"report", project, "-o", folder_ / report, "--quiet"}).code, 0) << report;
    EXPECT_GT(fs::file_size(folder_ / report), 1000u) << report;
  }
  for (const char* view : {"map", "3d"}) {
    const ProgramRun run = run_stemwise({"snapshot", project, "-o", folder_ / "p.png", "--view", view, "--size", "640x400"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_GT(fs::file_size(folder_ / "p.png"), 2000u);
  }
  for (const char* file : {"t.gpkg", "t.geojson", "t.csv"}) {
    const ProgramRun run = run_stemwise({"export", project, "-o", folder_ / file});
    EXPECT_EQ(run.code, 0) << file << run.err;
  }
  EXPECT_THAT(text_of(folder_ / "t.csv"), HasSubstr("tree_id"));
}

TEST_F(SmallProject, UnwritableResultsAreExitCode1) {
  const std::string project = folder_ / "project.gpkg";
  EXPECT_EQ(run_stemwise({"report", project, "-o", folder_ / "no/r.html"}).code, 1);
  EXPECT_EQ(run_stemwise({"snapshot", project, "-o", folder_ / "no/p.png"}).code, 1);
  EXPECT_EQ(run_stemwise({"export", project, "-o", folder_ / "no/t.csv"}).code, 1);
}

TEST(Align, TwoUnrelatedForestsAreRefusedWithTheReasonAndNoProject) {
  const Folder folder;
  ASSERT_EQ(run_stemwise({"simulate", "-o", folder / "a", "--years", "2015", "--stems", "120", "--seed", "1", "--quiet"}).code, 0);
  ASSERT_EQ(run_stemwise({"simulate", "-o", folder / "b", "--years", "2019", "--stems", "120", "--seed", "2", "--quiet"}).code, 0);
  const ProgramRun run = run_stemwise({"align", folder / "a/2015.csv", folder / "b/2019.csv", "-o", folder / "p.gpkg", "--json", "-", "--quiet"});
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_FALSE(fs::exists(folder / "p.gpkg"));
  const auto json = nlohmann::json::parse(run.out);
  bool refused = false;
  for (const auto& inventory : json["inventories"]) refused = refused || (inventory["status"] != "reference" && inventory["reason"].is_string());
  EXPECT_TRUE(refused);
}

TEST(Interrupt, StopsTheWorkAndLeavesNothing) {
  const Folder folder;
  ASSERT_EQ(run_stemwise({"simulate", "-o", folder / "s", "--years", "2015,2019", "--stems", "4000", "--quiet"}).code, 0);
  const ProgramRun run = interrupt_stemwise({"align", folder / "s/2015.csv", folder / "s/2019.csv", "-o", folder / "p.gpkg"});
  EXPECT_EQ(run.code, 130) << run.err;
  EXPECT_FALSE(fs::exists(folder / "p.gpkg"));
  for (const auto& entry : fs::directory_iterator(folder.path())) EXPECT_EQ(entry.path().filename(), "s");
}

}  // namespace
}  // namespace stemwise::testing
