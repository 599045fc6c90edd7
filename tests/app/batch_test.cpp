#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "io/project_file.hpp"
#include "tests/app/run_program.hpp"

namespace stemwise::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// One plot of two surveys, done once.
class Batch : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_stemwise({"simulate", "-o", folder_ / "forest", "--years", "2018,2023", "--stems", "120", "--seed", "3", "-q"}).code, 0);
    manifest_ = folder_.file("plots.csv", "plot,path\nA,forest/2018.csv\nA,forest/2023.csv\n");
    ASSERT_EQ(run({}).code, 0);
    project_ = text_of(folder_ / "out/A/project.gpkg");
    ASSERT_FALSE(project_.empty());
  }
  ProgramRun run(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"batch", manifest_, "-o", folder_ / "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_stemwise(arguments);
  }
  Folder folder_;
  std::string manifest_, project_;
};

TEST_F(Batch, AMistypedSettingTouchesNothing) {
  const std::string summary = text_of(folder_ / "out/summary.csv");
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--set", "nonsense=1"}, {"--set", "x"}, {"--config", folder_ / "none.json"}}) {
    const ProgramRun failed = run(more);
    EXPECT_EQ(failed.code, 2) << failed.err;
    EXPECT_EQ(text_of(folder_ / "out/A/project.gpkg"), project_);
    EXPECT_EQ(text_of(folder_ / "out/summary.csv"), summary);
  }
}

TEST_F(Batch, ARerunMakesAgainWhatIsMissingOrBroken) {
  EXPECT_THAT(run({}).err, HasSubstr("unchanged"));
  fs::remove(folder_ / "out/A/project.gpkg");
  EXPECT_EQ(run({}).code, 0);
  EXPECT_TRUE(is_project(folder_ / "out/A/project.gpkg"));
  fs::remove(folder_ / "out/A/align.json");
  EXPECT_EQ(run({}).code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out/A/align.json"));
  folder_.file("out/A/project.gpkg", "garbage");
  EXPECT_EQ(run({}).code, 0);
  EXPECT_TRUE(is_project(folder_ / "out/A/project.gpkg"));
  EXPECT_THAT(run({}).err, HasSubstr("unchanged"));
}

TEST_F(Batch, NothingButThePlotsFolderIsLeft) {
  EXPECT_EQ(run({"--seed", "4"}).code, 0);
  const auto entries = std::distance(fs::directory_iterator(folder_ / "out"), fs::directory_iterator());
  EXPECT_EQ(entries, 3);  // A, summary.csv, timing.csv
}

}  // namespace
}  // namespace stemwise::testing
