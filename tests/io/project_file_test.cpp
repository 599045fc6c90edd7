#include "io/project_file.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "core/base/random.hpp"
#include "core/project/commands.hpp"
#include "core/project/project.hpp"
#include "tests/io/sample_project.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class ProjectFileTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("stemwise-" + std::to_string(::getpid()) + "-" + info->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  fs::path folder_;
};

TEST_F(ProjectFileTest, EveryFieldOfTheStateComesBackEqual) {
  const ProjectState state = sample_project();
  const auto written = write_project(state, path("p.gpkg"));
  ASSERT_TRUE(written) << to_string(written.issues.front());
  const auto read = read_project(path("p.gpkg"));
  ASSERT_TRUE(read) << to_string(read.issues.front());
  EXPECT_EQ(read->title, state.title);
  EXPECT_EQ(read->alignments, state.alignments);
  EXPECT_EQ(read->coverages, state.coverages);
  EXPECT_EQ(read->pairs, state.pairs);
  EXPECT_EQ(read->matches, state.matches);
  EXPECT_EQ(read->trees, state.trees);
  EXPECT_EQ(read->tree_of_stem, state.tree_of_stem);
  EXPECT_EQ(read->georeference, state.georeference);
  EXPECT_EQ(read->settings, state.settings);
  EXPECT_EQ(read->edit_log, state.edit_log);
  EXPECT_EQ(read->dbh_error_m, state.dbh_error_m);
  ASSERT_EQ(read->inventories.size(), state.inventories.size());
  for (std::size_t i = 0; i < state.inventories.size(); ++i) {
    EXPECT_EQ(read->inventories[i]->source, state.inventories[i]->source);
    EXPECT_EQ(read->inventories[i]->stems, state.inventories[i]->stems);
  }
  EXPECT_TRUE(*read == state);
}

TEST_F(ProjectFileTest, AnEmptyProjectComesBackEqual) {
  ASSERT_TRUE(write_project(ProjectState{}, path("empty.gpkg")));
  const auto read = read_project(path("empty.gpkg"));
  ASSERT_TRUE(read);
  EXPECT_TRUE(*read == ProjectState{});
}

TEST_F(ProjectFileTest, TheFileIsAGeoPackageWithMapLayersInTheUtmZoneOfTheAnchor) {
  ASSERT_TRUE(write_project(sample_project(), path("p.gpkg")));
  GDALAllRegister();
  auto* dataset = GDALDataset::Open(path("p.gpkg").c_str(), GDAL_OF_VECTOR);
  ASSERT_NE(dataset, nullptr);
  for (const char* name : {"trees", "observations", "matches", "links", "inventories", "coverage"}) EXPECT_NE(dataset->GetLayerByName(name), nullptr) << name;
  OGRLayer* trees = dataset->GetLayerByName("trees");
  EXPECT_GT(trees->GetFeatureCount(), 0);
  ASSERT_NE(trees->GetSpatialRef(), nullptr);
  EXPECT_STREQ(trees->GetSpatialRef()->GetAuthorityCode(nullptr), "32756");
  GDALClose(dataset);
}

TEST_F(ProjectFileTest, WritingTwiceAtAFixedTimeGivesTheSameBytes) {
  ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  const ProjectState state = sample_project();
  ASSERT_TRUE(write_project(state, path("a.gpkg")));
  ASSERT_TRUE(write_project(state, path("b.gpkg")));
  ::unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_TRUE(bytes_of(path("a.gpkg")) == bytes_of(path("b.gpkg")));
}

TEST_F(ProjectFileTest, AFileThatIsNoProjectIsRefusedWithItsName) {
  std::ofstream(path("x.gpkg")) << "x,y\n1,2\n";
  const auto read = read_project(path("x.gpkg"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.issues.front().file, path("x.gpkg"));
  EXPECT_FALSE(is_project(path("x.gpkg")));
  EXPECT_FALSE(read_project(path("missing.gpkg")));
  EXPECT_FALSE(read_project(folder_.string()));
}

TEST_F(ProjectFileTest, ATruncatedFileIsRefusedAndLeftAsItIs) {
  ASSERT_TRUE(write_project(sample_project(), path("p.gpkg")));
  const auto size = fs::file_size(path("p.gpkg"));
  for (const double share : {0.2, 0.5, 0.8, 0.95}) {
    fs::copy_file(path("p.gpkg"), path("cut.gpkg"), fs::copy_options::overwrite_existing);
    fs::resize_file(path("cut.gpkg"), static_cast<std::uintmax_t>(static_cast<double>(size) * share));
    const std::string before = bytes_of(path("cut.gpkg"));
    EXPECT_FALSE(read_project(path("cut.gpkg"))) << share;
    EXPECT_TRUE(bytes_of(path("cut.gpkg")) == before);
  }
}

TEST_F(ProjectFileTest, AStemThatLiesOffTheEarthIsDamage) {
  ProjectState state = sample_project();
  Inventory first = *state.inventories.front();
  first.stems.front().x_m = 1e300;
  state.inventories.front() = std::make_shared<const Inventory>(first);
  ASSERT_TRUE(write_project(state, path("p.gpkg")));
  const auto read = read_project(path("p.gpkg"));
  ASSERT_FALSE(read);
  EXPECT_NE(to_string(read.issues.front()).find("off the earth"), std::string::npos) << to_string(read.issues.front());
}

TEST_F(ProjectFileTest, ALinkStaysALinkAndTheFileItNamesIsWritten) {
  ASSERT_TRUE(write_project(ProjectState{}, path("p.gpkg")));
  fs::create_symlink("p.gpkg", path("link.gpkg"));
  ASSERT_TRUE(write_project(sample_project(), path("link.gpkg")));
  EXPECT_TRUE(fs::is_symlink(path("link.gpkg")));
  const auto read = read_project(path("p.gpkg"));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, sample_project());
}

TEST_F(ProjectFileTest, AFolderThatCannotBeWrittenLeavesNothingBehind) {
  EXPECT_FALSE(write_project(sample_project(), path("no/such/folder/p.gpkg")));
  fs::create_directories(path("taken.gpkg"));
  EXPECT_FALSE(write_project(sample_project(), path("taken.gpkg")));
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++files;
  EXPECT_EQ(files, 1U);
}

TEST_F(ProjectFileTest, FiveSurveysOfTwentyThousandStemsComeBackEqual) {
  const ProjectState state = large_project(20000, 5);
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(write_project(state, path("large.gpkg")));
  const auto middle = std::chrono::steady_clock::now();
  const auto read = read_project(path("large.gpkg"));
  const auto end = std::chrono::steady_clock::now();
  std::cout << "write " << std::chrono::duration<double>(middle - start).count() << " s, read " << std::chrono::duration<double>(end - middle).count()
            << " s, " << fs::file_size(path("large.gpkg")) / 1000000 << " MB\n";
  ASSERT_TRUE(read);
  EXPECT_TRUE(*read == state);
}

}  // namespace
}  // namespace stemwise
