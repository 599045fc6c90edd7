#include "io/project_stamp.hpp"

#include <fcntl.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

#include "core/project/commands.hpp"
#include "core/project/project.hpp"
#include "io/project_file.hpp"
#include "tests/io/sample_project.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

class ProjectStampTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("stemwise-" + std::to_string(::getpid()) + "-" + info->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// As another program does: some SQL in the file.
  static void change(const std::string& path, const std::string& sql) {
    GDALAllRegister();
    std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    ASSERT_NE(dataset, nullptr);
    dataset->ReleaseResultSet(dataset->ExecuteSQL(sql.c_str(), nullptr, nullptr));
  }
  static ProjectState titled(const std::string& title) {
    Project project(sample_project());
    project.execute(set_title(title));
    return project.state();
  }
  std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator())); }

  fs::path folder_;
};

TEST_F(ProjectStampTest, IsOfWhatTheProjectHoldsAndNotOfTheFile) {
  const auto first = write_project(sample_project(), path("a.gpkg"));
  const auto same = write_project(sample_project(), path("b.gpkg"));
  const auto other = write_project(titled("another"), path("c.gpkg"));
  ASSERT_TRUE(first && same && other);
  EXPECT_FALSE(first->text.empty());
  EXPECT_EQ(*first, *same);
  EXPECT_NE(*first, *other);
  EXPECT_EQ(project_stamp(path("a.gpkg")), *first);
  change(path("a.gpkg"), "CREATE TABLE plans_of_mine (id INTEGER PRIMARY KEY, words TEXT)");
  EXPECT_EQ(project_stamp(path("a.gpkg")), *first);  // QGIS keeps things of its own in there
}

TEST_F(ProjectStampTest, AFileThatWasChangedInTheMeantimeIsNotReplaced) {
  const auto read_here = write_project(sample_project(), path("p.gpkg"));
  const auto saved_elsewhere = write_project(titled("elsewhere"), path("p.gpkg"));
  ASSERT_TRUE(read_here && saved_elsewhere);
  const auto refused = write_project(titled("here"), path("p.gpkg"), *read_here);
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.issues.front()).find("changed by another window or program"), std::string::npos) << to_string(refused.issues.front());
  EXPECT_EQ(read_project(path("p.gpkg"))->title, "elsewhere");
  EXPECT_EQ(files(), 1u);
  EXPECT_TRUE(write_project(titled("here"), path("p.gpkg"), *saved_elsewhere));
  EXPECT_EQ(read_project(path("p.gpkg"))->title, "here");
}

TEST_F(ProjectStampTest, WhereTheFileIsGoneNothingCanBeLost) {
  const auto read_here = write_project(sample_project(), path("p.gpkg"));
  fs::remove(path("p.gpkg"));
  EXPECT_EQ(project_stamp(path("p.gpkg")), ProjectStamp{});
  EXPECT_TRUE(write_project(titled("here"), path("p.gpkg"), *read_here));
}

TEST_F(ProjectStampTest, AFileThatIsNewWhereNoneWasKnownIsNotReplaced) {
  ASSERT_TRUE(write_project(sample_project(), path("p.gpkg")));
  EXPECT_FALSE(write_project(titled("here"), path("p.gpkg"), ProjectStamp{}));
}

TEST_F(ProjectStampTest, AProjectOfAnOlderVersionIsKnownByItsFile) {
  ASSERT_TRUE(write_project(sample_project(), path("p.gpkg")));
  change(path("p.gpkg"), "DELETE FROM stemwise_project WHERE key = 'fingerprint'");
  const ProjectStamp known = project_stamp(path("p.gpkg"));
  EXPECT_TRUE(known.text.starts_with("file ")) << known.text;
  EXPECT_FALSE(is_changed_since(known, path("p.gpkg")));
  change(path("p.gpkg"), "UPDATE stemwise_project SET value = 'other' WHERE key = 'title'");
  EXPECT_TRUE(is_changed_since(known, path("p.gpkg")));
}

TEST_F(ProjectStampTest, WhileAnotherProgramReplacesTheFileNothingIsWritten) {
  const auto known = write_project(sample_project(), path("p.gpkg"));
  const int held = ::open(path("p.gpkg").c_str(), O_RDONLY);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  EXPECT_FALSE(write_project(titled("here"), path("p.gpkg"), *known));
  ::close(held);
  EXPECT_TRUE(write_project(titled("here"), path("p.gpkg"), *known));
}

TEST_F(ProjectStampTest, AProjectOfANewerVersionIsNotCalledDamaged) {
  ASSERT_TRUE(write_project(sample_project(), path("p.gpkg")));
  change(path("p.gpkg"), "UPDATE stemwise_project SET value = '99' WHERE key = 'format_version'");
  const auto read = read_project(path("p.gpkg"));
  ASSERT_FALSE(read);
  const std::string words = to_string(read.issues.front());
  EXPECT_NE(words.find("needs a newer Stemwise"), std::string::npos) << words;
  EXPECT_EQ(words.find("damaged"), std::string::npos) << words;
}

}  // namespace
}  // namespace stemwise
