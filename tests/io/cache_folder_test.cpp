#include "io/cache_folder.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace stemwise {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text.data(), text.size())); }

class CacheFolderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    path_ = fs::temp_directory_path() / ("stemwise_cache_" + std::to_string(::getpid()) + "_" + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(path_);
  }
  void TearDown() override {
    fs::remove_all(path_);
  }
  CacheFolder cache(std::uint64_t most_bytes = 1 << 20) const { return CacheFolder((path_ / "deep" / "er").string(), most_bytes); }
  static bool keep(const CacheFolder& cache, const std::string& key, const std::string& a, const std::string& b = "") {
    const std::array parts{bytes_of(a), bytes_of(b)};
    return cache.keep("thing", key, parts);
  }
  /// Both parts; "none" where there is no entry, "torn" where it is not whole.
  static std::string found(const CacheFolder& cache, const std::string& key) {
    auto reader = cache.find("thing", key);
    if (!reader) return "none";
    std::string text;
    for (std::size_t p = 0; p < reader->parts(); ++p) {
      std::string part(reader->size_of(p), '?');
      if (!reader->read_next(std::as_writable_bytes(std::span(part)))) return "torn";
      text += part + (p == 0 ? "|" : "");
    }
    return reader->is_whole() ? text : "torn";
  }
  std::size_t files() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(path_ / "deep" / "er")) ++count;
    return count;
  }

  fs::path path_;
};

TEST_F(CacheFolderTest, GivesBackWhatWasKeptUnderTheSameKindAndKeyOnly) {
  const auto c = cache();
  EXPECT_EQ(found(c, "key"), "none");
  const std::string large(700'001, 'x');  // several pieces, no multiple of a word
  ASSERT_TRUE(keep(c, "key", "abc", large));
  EXPECT_EQ(found(c, "key"), "abc|" + large);
  EXPECT_EQ(found(c, "kez"), "none");
  EXPECT_EQ(found(c, "key "), "none");
  EXPECT_FALSE(c.find("other", "key"));
  ASSERT_TRUE(keep(c, "key", "new"));
  EXPECT_EQ(found(c, "key"), "new|");
  EXPECT_EQ(files(), 1U) << "nothing is left beside the entry";
}

TEST_F(CacheFolderTest, AnEntryUnderTheNameOfAnotherKeyIsNone) {
  const auto c = cache();
  ASSERT_TRUE(keep(c, "one", "abc"));
  fs::copy_file(c.path_of("thing", "one"), c.path_of("thing", "two"));  // as if both keys had the same sum
  EXPECT_EQ(found(c, "two"), "none");
}

TEST_F(CacheFolderTest, ATornOrChangedEntryIsNeverWhole) {
  const auto c = cache();
  const std::string path = c.path_of("thing", "key");
  ASSERT_TRUE(keep(c, "key", "abcdefgh", std::string(300'000, 'y')));
  const auto size = fs::file_size(path);
  std::ifstream in(path, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), {});
  for (const std::size_t end : {std::size_t{0}, std::size_t{5}, std::size_t{40}, std::size_t{size / 2}, std::size_t{size - 1}}) {
    fs::resize_file(path, end);
    EXPECT_EQ(found(c, "key"), "none") << end << " bytes";
    std::ofstream(path, std::ios::binary) << whole;
  }
  for (const std::size_t at : {std::size_t{0}, std::size_t{8}, std::size_t{17}, std::size_t{33}, std::size_t{60}, std::size_t{80000}, std::size_t{size - 1}}) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    std::ofstream(path, std::ios::binary) << changed;
    EXPECT_TRUE(found(c, "key") == "none" || found(c, "key") == "torn") << "byte " << at;
  }
  std::ofstream(path, std::ios::binary) << whole + "z";
  EXPECT_EQ(found(c, "key"), "none");
  ASSERT_TRUE(keep(c, "key", "again"));
  EXPECT_EQ(found(c, "key"), "again|") << "a torn entry is replaced";
}

TEST_F(CacheFolderTest, StaysBelowItsBoundAndForgetsWhatWasNotUsedForLongest) {
  const auto c = cache(10'000);
  const std::string text(2'500, 't');
  const auto old = fs::file_time_type::clock::now() - 10h;
  int hour = 0;
  for (const char* key : {"a", "b", "c"}) {
    ASSERT_TRUE(keep(c, key, text));
    fs::last_write_time(c.path_of("thing", key), old + ++hour * 1h);
  }
  EXPECT_EQ(found(c, "a"), text + "|");  // used now
  ASSERT_TRUE(keep(c, "d", text));
  EXPECT_EQ(found(c, "b"), "none");
  for (const char* key : {"a", "c", "d"}) EXPECT_EQ(found(c, key), text + "|") << key;
  EXPECT_FALSE(keep(c, "e", std::string(10'001, 't'))) << "larger than all may be";
  EXPECT_EQ(files(), 3U);
}

TEST_F(CacheFolderTest, ClearsAwayWhatAnInterruptedRunLeftButNotWhatOneIsWriting) {
  const auto c = cache();
  ASSERT_TRUE(keep(c, "a", "1"));
  const std::string left = c.path_of("thing", "b") + ".unfinishedAAAAAA", writing = c.path_of("thing", "c") + ".unfinishedBBBBBB";
  std::ofstream(left) << "half";
  std::ofstream(writing) << "half";
  fs::last_write_time(left, fs::file_time_type::clock::now() - 2h);
  ASSERT_TRUE(keep(c, "a", "2"));
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(writing));
}

TEST_F(CacheFolderTest, MayBeDeletedAtAnyTimeAndNeedNotBeWritable) {
  const auto c = cache();
  ASSERT_TRUE(keep(c, "key", "abc"));
  auto reader = c.find("thing", "key");
  ASSERT_TRUE(reader);
  fs::remove_all(path_);
  std::string part(3, '?');
  EXPECT_TRUE(reader->read_next(std::as_writable_bytes(std::span(part))));
  EXPECT_EQ(part, "abc") << "who had it open still reads it";
  EXPECT_EQ(found(c, "key"), "none");
  ASSERT_TRUE(keep(c, "key", "abc"));
  EXPECT_EQ(found(c, "key"), "abc|");
  const CacheFolder nowhere("/dev/null/stemwise", 1 << 20);
  EXPECT_FALSE(keep(nowhere, "key", "abc"));
  EXPECT_EQ(found(nowhere, "key"), "none");
}

}  // namespace
}  // namespace stemwise
