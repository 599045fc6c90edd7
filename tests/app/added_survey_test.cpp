#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/project/commands.hpp"
#include "core/project/project.hpp"
#include "io/project_file.hpp"
#include "tests/app/run_program.hpp"

// A survey added to a saved project (issue 5): every id stays; taken out again, the file holds what it held before.
namespace stemwise::testing {
namespace {

class AddedSurvey : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_stemwise({"simulate", "-o", folder_ / "s", "--stems", "150", "--seed", "5", "--quiet"}).code, 0);
    ASSERT_EQ(run_stemwise({"align", folder_ / "s/2015.csv", folder_ / "s/2023.csv", "-o", folder_ / "before.gpkg", "--quiet"}).code, 0);
    ASSERT_EQ(run_stemwise({"align", folder_ / "before.gpkg", folder_ / "s/2019.csv", "-o", folder_ / "after.gpkg", "--quiet"}).code, 0);
    before_ = *read_project(folder_ / "before.gpkg");
    after_ = *read_project(folder_ / "after.gpkg");
  }
  Folder folder_;
  ProjectState before_, after_;
};

TEST_F(AddedSurvey, KeepsEveryTreeIdAndEveryStemOfIt) {
  ASSERT_EQ(after_.inventories.size(), 3U);
  EXPECT_TRUE(after_.is_placed(after_.find("2019")->id));
  int joined = 0;
  for (const auto& [id, tree] : before_.trees) {
    ASSERT_TRUE(after_.trees.contains(id));
    const std::vector<StemRef>& stems = after_.trees.at(id).stems;
    for (const StemRef& stem : tree.stems) EXPECT_TRUE(std::find(stems.begin(), stems.end(), stem) != stems.end());
    EXPECT_LE(stems.size(), tree.stems.size() + 1);
    joined += stems.size() > tree.stems.size() ? 1 : 0;
  }
  EXPECT_GT(joined, 80) << "the new survey's stems joined the trees that were there";
}

TEST_F(AddedSurvey, TakenOutAgainLeavesInTheFileWhatWasThereBefore) {
  Project project(after_);
  project.execute(remove_inventory(after_.find("2019")->id));
  ASSERT_TRUE(write_project(project.state(), folder_ / "again.gpkg"));
  ProjectState again = *read_project(folder_ / "again.gpkg");
  EXPECT_GE(again.next_tree, before_.next_tree) << "an id that was given once is never given again";
  again.next_tree = before_.next_tree;
  again.next_inventory = before_.next_inventory;
  EXPECT_EQ(again.trees, before_.trees);
  EXPECT_EQ(again.matches, before_.matches);
  EXPECT_EQ(again.alignments, before_.alignments);
  EXPECT_EQ(again.coverages, before_.coverages);
  EXPECT_EQ(again.pairs, before_.pairs);
  EXPECT_TRUE(again == before_);
}

TEST_F(AddedSurvey, IsTakenOutByTheCommandLineAsWell) {
  ASSERT_EQ(run_stemwise({"remove", folder_ / "after.gpkg", "2019", "-o", folder_ / "again.gpkg", "--quiet"}).code, 0);
  const ProjectState again = *read_project(folder_ / "again.gpkg");
  EXPECT_EQ(again.trees, before_.trees);
  EXPECT_EQ(again.matches, before_.matches);
  EXPECT_EQ(again.alignments, before_.alignments);
  EXPECT_EQ(run_stemwise({"remove", folder_ / "after.gpkg", "1999"}).code, 2);
  EXPECT_EQ(run_stemwise({"remove", folder_ / "after.gpkg", after_.find(after_.reference)->name}).code, 2) << "everything lies in the reference's frame";
  EXPECT_EQ(*read_project(folder_ / "after.gpkg"), after_);
}

}  // namespace
}  // namespace stemwise::testing
