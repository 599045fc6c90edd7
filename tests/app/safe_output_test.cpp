#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/project/commands.hpp"
#include "core/project/project.hpp"
#include "io/project_file.hpp"
#include "tests/app/run_program.hpp"

namespace stemwise::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A small forest surveyed twice, and its project.
class SafeOutput : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_stemwise({"simulate", "-o", folder_ / "forest", "--years", "2018,2023", "--stems", "150", "--seed", "3"}).code, 0);
    first_ = folder_ / "forest/2018.csv", second_ = folder_ / "forest/2023.csv", project_ = folder_ / "stand.gpkg";
    const ProgramRun run = run_stemwise({"align", first_, second_, "-o", project_, "--json", folder_ / "align.json"});
    ASSERT_EQ(run.code, 0) << run.err;
  }
  Folder folder_;
  std::string first_, second_, project_;
};

TEST_F(SafeOutput, NothingIsWrittenOverWhatIsReadOrOverAProject) {
  const std::string survey = text_of(first_), project = text_of(project_);
  fs::copy_file(project_, folder_ / "other.gpkg");
  const std::vector<std::vector<std::string>> harmful{{"align", first_, second_, "-o", first_},
                                                      {"align", first_, second_, "-o", folder_ / "project.csv"},
                                                      {"convert", first_, "-o", first_},
                                                      {"export", project_, "-o", project_},
                                                      {"export", project_, "-o", folder_ / "other.gpkg"},
                                                      {"report", project_, "-o", project_},
                                                      {"snapshot", project_, "-o", project_}};
  for (const auto& arguments : harmful) {
    const ProgramRun run = run_stemwise(arguments);
    EXPECT_EQ(run.code, 2) << arguments.front() << ": " << run.err;
    EXPECT_THAT(run.err, HasSubstr("-o"));
  }
  EXPECT_EQ(text_of(first_), survey);
  EXPECT_EQ(text_of(project_), project);
  EXPECT_EQ(text_of(folder_ / "other.gpkg"), project);
  EXPECT_FALSE(fs::exists(folder_ / "project.csv"));
}

TEST_F(SafeOutput, NothingOfOthersIsReplaced) {
  ASSERT_EQ(run_stemwise({"export", project_, "-o", folder_ / "trees.gpkg", "--layer", "trees", "--crs", "EPSG:32632", "-q"}).code, 1);  // not on the earth
  ASSERT_EQ(run_stemwise({"georeference", project_, "--anchor", "48.77214,9.16621,412.5,37", "-q"}).code, 0);
  ASSERT_EQ(run_stemwise({"export", project_, "-o", folder_ / "trees.gpkg", "--layer", "trees", "-q"}).code, 0);
  const std::string of_others = text_of(folder_ / "trees.gpkg"), survey = text_of(first_);
  fs::create_directories(folder_ / "mine");
  folder_.file("mine/2018.csv", survey);
  const std::vector<std::vector<std::string>> harmful{{"align", first_, second_, "-o", folder_ / "trees.gpkg"},
                                                      {"export", project_, "-o", first_},
                                                      {"simulate", "-o", folder_ / "mine", "--years", "2018,2023", "--stems", "50"}};
  for (const auto& arguments : harmful) EXPECT_EQ(run_stemwise(arguments).code, 2) << arguments.front();
  EXPECT_EQ(text_of(folder_ / "trees.gpkg"), of_others);
  EXPECT_EQ(text_of(first_), survey);
  EXPECT_EQ(text_of(folder_ / "mine/2018.csv"), survey);
}

TEST_F(SafeOutput, AProjectMayBeWrittenAgain) { EXPECT_EQ(run_stemwise({"align", first_, second_, "-o", project_}).code, 0); }

TEST_F(SafeOutput, AResultIsNeverWrittenOverAnythingButAResult) {
  const std::string survey = text_of(first_), project = text_of(project_);
  const std::vector<std::vector<std::string>> harmful{{"info", first_, "--json", first_},
                                                      {"align", first_, second_, "-o", folder_ / "more.gpkg", "--json", first_},
                                                      {"export", project_, "-o", folder_ / "trees.csv", "--json", project_},
                                                      {"georeference", project_, "--anchor", "48.77214,9.16621,412.5,37", "--json", project_},
                                                      {"align", first_, second_, "-o", folder_ / "more.gpkg", "--config", folder_ / "align.json", "--json", folder_ / "align.json"},
                                                      {"export", project_, "-o", folder_ / "trees.geojson", "--json", folder_ / "trees.geojson"}};
  for (const auto& arguments : harmful) {
    const ProgramRun run = run_stemwise(arguments);
    EXPECT_EQ(run.code, 2) << arguments.front() << ": " << run.err;
    EXPECT_THAT(run.err, HasSubstr("--json"));
  }
  EXPECT_EQ(text_of(first_), survey);
  EXPECT_EQ(text_of(project_), project);
  EXPECT_EQ(run_stemwise({"info", first_, "-q", "--json", folder_ / "align.json"}).code, 0);
  EXPECT_EQ(run_stemwise({"align", first_, second_, "-q", "-o", folder_ / "both.gpkg", "--json", folder_ / "both.gpkg"}).code, 2);
}

TEST_F(SafeOutput, WhatAPersonEditedIsNotAlignedAway) {
  Result<ProjectState> read = read_project(project_);
  ASSERT_TRUE(read);
  Project edited(*read);
  edited.execute(set_tree_note(edited.state().trees.begin()->first, "the old oak", {"me", "2026-11-22T08:00:00Z", ""}));
  if (edited.state().edit_log.empty()) edited.execute(set_fate(edited.state().trees.begin()->first, Fate::dead, {"me", "2026-11-22T08:00:00Z", ""}));
  ASSERT_TRUE(write_project(edited.state(), project_));
  const std::string before = text_of(project_);
  const ProgramRun run = run_stemwise({"align", first_, second_, "-o", project_});
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("edits made by hand"));
  EXPECT_EQ(text_of(project_), before);
  fs::copy_file(second_, folder_ / "2024.csv");
  EXPECT_EQ(run_stemwise({"align", project_, folder_ / "2024.csv", "-o", project_}).code, 0);
  EXPECT_FALSE(read_project(project_)->edit_log.empty());

  const std::string manifest = folder_.file("plots.csv", "plot,path\nA," + first_ + "\nA," + second_ + "\n");
  ASSERT_EQ(run_stemwise({"batch", manifest, "-o", folder_ / "out"}).code, 0);
  fs::copy_file(project_, folder_ / "out/A/project.gpkg", fs::copy_options::overwrite_existing);
  const std::string kept = text_of(folder_ / "out/A/project.gpkg");
  run_stemwise({"batch", manifest, "-o", folder_ / "out", "--seed", "5"});
  EXPECT_EQ(text_of(folder_ / "out/A/project.gpkg"), kept);
  EXPECT_THAT(text_of(folder_ / "out/summary.csv"), HasSubstr("was left as it is"));
}

TEST_F(SafeOutput, EveryCommandWritesItsJson) {
  const std::vector<std::vector<std::string>> commands{{"merge", project_, "--policy", "newest"},
                                                       {"georeference", project_, "--anchor", "48.77214,9.16621,412.5,37"},
                                                       {"export", project_, "-o", folder_ / "trees.csv"},
                                                       {"report", project_, "-o", folder_ / "report.html"},
                                                       {"convert", first_, "-o", folder_ / "copy.csv"},
                                                       {"simulate", "-o", folder_ / "more", "--stems", "20"}};
  for (auto arguments : commands) {
    arguments.insert(arguments.end(), {"--quiet", "--json", "-"});
    const ProgramRun run = run_stemwise(arguments);
    EXPECT_EQ(run.code, 0) << arguments.front() << ": " << run.err;
    EXPECT_TRUE(nlohmann::json::parse(run.out, nullptr, false).is_object()) << arguments.front() << ": " << run.out;
  }
}

TEST_F(SafeOutput, AnAnchorThatIsNoPlaceIsBadUsage) {
  for (const char* anchor : {"nan,9,4,3", "48,200,4,3", "90,0,0,0", "48,9,4,400", "48,9,4", "48,9,inf,3"})
    EXPECT_EQ(run_stemwise({"georeference", project_, "--anchor", anchor}).code, 2) << anchor;
}

TEST_F(SafeOutput, LocalCoordinatesAreNotTakenForAnotherPartOfTheEarth) {
  const ProgramRun run = run_stemwise({"georeference", project_, "--crs", "EPSG:32632"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("local"));
}

TEST_F(SafeOutput, ADeathThatTheCrewRecordedIsAFate) {
  const std::string text = text_of(second_);
  const auto recorded = std::count(text.begin(), text.end(), '\n') - 1;
  ASSERT_GT(recorded, 50);
  std::size_t dead = 0;
  for (std::size_t at = 0; (at = text.find(",dead,", at)) != std::string::npos; ++at) ++dead;
  const auto json = nlohmann::json::parse(text_of(folder_ / "align.json"));
  EXPECT_EQ(json["trees"]["by_fate"]["dead"], dead);
  EXPECT_GT(dead, 0U);
}

}  // namespace
}  // namespace stemwise::testing
