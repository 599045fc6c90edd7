#include "app/platform/file_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "tests/app/run_program.hpp"

namespace stemwise::platform {
namespace {

TEST(FileLock, IsHeldByOneAndGoesWithIt) {
  const testing::Folder folder;
  const std::string path = folder / "a.lock";
  EXPECT_FALSE(is_locked(path));
  {
    auto lock = FileLock::take(path);
    ASSERT_TRUE(lock);
    EXPECT_TRUE(is_locked(path));
    EXPECT_FALSE(FileLock::take(path));
    lock->write("a longer text");
    lock->write("text");
    EXPECT_EQ(testing::text_of(path), "text");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_TRUE(FileLock::take(path));
}

TEST(FileLock, WhereThereIsNoFolderThereIsNoLock) {
  const testing::Folder folder;
  EXPECT_FALSE(FileLock::take(folder / "none/a.lock"));
}

TEST(FileLock, EndsWithAKilledProcessAlsoWhileItIsAZombie) {
  const testing::Folder folder;
  const std::string path = folder / "a.lock";
  int ready[2] = {};
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const auto lock = FileLock::take(path);
    const char word = lock ? 'y' : 'n';
    if (write(ready[1], &word, 1) != 1) _exit(1);
    while (true) pause();
  }
  char word = 0;
  ASSERT_EQ(read(ready[0], &word, 1), 1);
  EXPECT_EQ(word, 'y');
  EXPECT_TRUE(is_locked(path));
  kill(child, SIGKILL);
  siginfo_t ended{};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT), 0);  // dead, and not buried: its number is still taken
  EXPECT_EQ(kill(child, 0), 0);
  EXPECT_FALSE(is_locked(path));
  EXPECT_TRUE(FileLock::take(path));
  waitpid(child, nullptr, 0);
  close(ready[0]);
  close(ready[1]);
}

}  // namespace
}  // namespace stemwise::platform
