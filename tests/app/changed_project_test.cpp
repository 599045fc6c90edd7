#include <gtest/gtest.h>

#include <atomic>

#include "app/commands/open_project.hpp"
#include "core/project/commands.hpp"
#include "io/project_file.hpp"
#include "tests/app/run_program.hpp"

namespace stemwise {
namespace {

TEST(ChangedProject, ACommandDoesNotLoseWhatAWindowSavedWhileItRan) {
  const testing::Folder folder;
  const std::string path = folder / "stand.gpkg";
  Project there;
  there.execute(set_title("as it was"));
  ASSERT_TRUE(write_project(there.state(), path));
  const CommonOptions common;
  Console console(true);
  const std::atomic<bool> cancel = false;
  Session session{common, console, cancel};
  auto opened = open_project(path, session);
  ASSERT_TRUE(opened);
  opened->project.execute(set_fusion_policy(FusionPolicy::newest));
  there.execute(set_title("as the window saved it"));
  ASSERT_TRUE(write_project(there.state(), path));
  EXPECT_EQ(save_project(path, *opened, session), ExitCode::failed);
  EXPECT_EQ(read_project(path)->title, "as the window saved it");
  EXPECT_EQ(save_project(folder / "other.gpkg", *opened, session), ExitCode::done);
  auto again = open_project(path, session);
  ASSERT_TRUE(again);
  EXPECT_EQ(save_project(path, *again, session), ExitCode::done);
}

}  // namespace
}  // namespace stemwise
