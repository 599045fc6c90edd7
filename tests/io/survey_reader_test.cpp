#include "io/survey_reader.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/treeloc/prepare_scene.hpp"
#include "core/treeloc/triangle_index.hpp"
#include "io/folder_stamp.hpp"
#include "io/read_frame_folder.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
using treeloc::Scene;
using treeloc::Settings;

constexpr int frame_count = 150;  // more than are read at once

std::int64_t an_hour_from_now_ns() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>((system_clock::now() + hours(1)).time_since_epoch()).count();
}

/// A walk along rows of trees; a few frames have few trees, so that preceding ones fill up, one a bad row, one cannot be read.
class SurveyReaderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    path_ = fs::temp_directory_path() / ("stemwise_survey_" + std::to_string(::getpid()) + "_" + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(path_);
    fs::create_directories(path_ / "walk");
    std::ofstream poses(path_ / "walk" / "trajectory.txt");
    for (int n = 0; n < frame_count; ++n) {
      poses << 1000 + n << " " << n << " 0 0 0 0 0 1\n";
      write_frame(n, n % 40 == 7 ? 3 : 26);
    }
    std::ofstream(frame(20), std::ios::app) << "1,x,0,0.3,1,1\n";
    std::ofstream(frame(30)) << "nothing,of,ours\n";
  }
  void TearDown() override { fs::remove_all(path_); }

  std::string frame(int n) const { return (path_ / "walk" / ("TreeManagerState_" + std::to_string(n) + ".csv")).string(); }
  void write_frame(int n, int trees, double shift_m = 0.0) const {
    std::ofstream out(frame(n));
    out << "location_x,location_y,location_z,dbh,reconstructed,number_clusters\n";
    for (int i = 0; i < trees; ++i) {
      const int tree = n / 4 + i;  // a row of trees, 4 m apart, that stands still while the frame moves on
      out << tree * 4 - n - 30 + (tree * 7 % 11) * 0.17 + shift_m << "," << (tree * 5 % 13) * 2.3 - 12 << ",-1.4," << 0.15 + (tree * 3 % 17) * 0.02 << ","
          << (tree % 5 == 0 ? 0 : 1) << ",2\n";
    }
  }
  std::string walk() const { return (path_ / "walk").string(); }
  SurveyCacheOptions options() const { return {(path_ / "cache").string(), 1 << 26, "build 1", an_hour_from_now_ns}; }
  std::size_t kept() const {
    std::size_t count = 0;
    std::error_code none;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(path_ / "cache", none)) ++count;
    return count;
  }

  fs::path path_;
};

/// Everything of a survey as one text, bit for bit.
std::string bits_of(const ReadSurvey& survey) {
  std::string bits = survey.name + "\n";
  const auto add = [&](const auto& values) { bits.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(*values.data())); };
  for (const Scene& s : survey.described.scenes) {
    bits += std::to_string(s.number) + (s.tilt_observed ? "t" : "f") + (s.level_sensor ? "t" : "f") + (s.ground_observed ? "t" : "f");
    add(s.survey_from_scene.rotation), add(s.survey_from_scene.translation_m), add(s.aligned_from_scene), add(std::array{s.ground_m});
    for (const treeloc::SceneTree& t : s.trees) {
      add(t.position_m), add(t.axis), add(std::array{t.dbh_m});
      bits += std::to_string(t.clusters) + (t.has_height ? "t" : "f") + (t.reconstructed ? "t" : "f") + (t.own ? "t" : "f");
    }
  }
  if (survey.described.triangles) {
    bits += std::to_string(survey.described.triangles->scene_count);
    add(survey.described.triangles->start), add(survey.described.triangles->origins), add(survey.described.triangles->postings);
  }
  return bits;
}

TEST_F(SurveyReaderTest, ReadsTheScenesThatTheWholeFolderGivesAtAnyThreadCount) {
  Settings settings;
  settings.scene.min_reconstructed = 10;  // so that preceding frames add to some
  const auto inventory = read_frame_folder(walk(), 1);
  ReadSurvey whole;
  whole.name = inventory->name;
  whole.described.scenes = treeloc::prepare_frame_scenes(*inventory->frames, settings.scene, settings.axes, 1);
  EXPECT_TRUE(std::any_of(whole.described.scenes.begin(), whole.described.scenes.end(),
                          [](const Scene& s) { return std::any_of(s.trees.begin(), s.trees.end(), [](const auto& t) { return !t.own; }); }));
  for (const int threads : {1, 3}) {
    const auto read = SurveyReader({}, threads).read(walk(), settings, false);
    ASSERT_TRUE(read);
    EXPECT_EQ(bits_of(*read), bits_of(whole));
    EXPECT_EQ(read.issues, inventory.issues);
    EXPECT_EQ(read.issues.size(), 2U);
    EXPECT_FALSE(read->scenes_from_cache);
  }
}

TEST_F(SurveyReaderTest, TheCacheGivesTheSameBitsAndSaysTheSameIssues) {
  const auto plain = SurveyReader({}, 2).read(walk(), {}, true);
  for (const bool again : {false, true}) {
    const auto read = SurveyReader(options(), 2).read(walk(), {}, true);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->scenes_from_cache, again);
    EXPECT_EQ(read->triangles_from_cache, again);
    EXPECT_EQ(bits_of(*read), bits_of(*plain));
    EXPECT_EQ(read.issues, plain.issues);
  }
  EXPECT_EQ(kept(), 2U);
  fs::remove_all(path_ / "cache");
  const auto without = SurveyReader(options(), 2).read(walk(), {}, true);
  EXPECT_FALSE(without->scenes_from_cache);
  EXPECT_EQ(bits_of(*without), bits_of(*plain));
}

TEST_F(SurveyReaderTest, AnyChangeOfAFileIsSeen) {
  const auto read = [&] { return SurveyReader(options(), 1).read(walk(), {}, true); };
  const auto from_cache = [&] { return read()->scenes_from_cache; };
  ASSERT_FALSE(from_cache());
  ASSERT_TRUE(from_cache());
  const auto time = fs::last_write_time(frame(3));
  const auto before = bits_of(*read());
  write_frame(3, 26, 0.001);
  fs::last_write_time(frame(3), time);  // as `cp -p` and `touch -r` do
  const auto changed = read();
  EXPECT_FALSE(changed->scenes_from_cache) << "a frame's content";
  EXPECT_NE(bits_of(*changed), before);
  EXPECT_TRUE(from_cache());
  fs::rename(frame(149), path_ / "149.csv");
  EXPECT_FALSE(from_cache()) << "a frame less";
  fs::rename(path_ / "149.csv", frame(149));
  EXPECT_FALSE(from_cache()) << "a frame more";
  std::ofstream(path_ / "walk" / "trajectory.txt", std::ios::app) << "\n";
  EXPECT_FALSE(from_cache()) << "the trajectory";
  EXPECT_TRUE(from_cache());
  std::ofstream(path_ / "walk" / "notes.txt") << "not ours";
  EXPECT_TRUE(from_cache());
}

TEST_F(SurveyReaderTest, EverySettingAndTheProgramBelongToTheKey) {
  Settings plain;
  plain.triangles.step_m = 0.5;  // few keys, small entries: none has to go
  const auto read = [&](const Settings& s) { return SurveyReader(options(), 1).read(walk(), s, true); };
  ASSERT_FALSE(read(plain)->scenes_from_cache);
  Settings keys = plain;
  for (const Field& given : keys.fields()) {
    Settings other = plain;
    const Fields fields = other.fields();
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.key == given.key; });
    if (auto* const* d = std::get_if<double*>(&field->value)) **d += 0.125;
    if (auto* const* i = std::get_if<int*>(&field->value)) **i += 1;
    if (auto* const* b = std::get_if<bool*>(&field->value)) **b = !**b;
    const bool of_scenes = given.key.starts_with("scene.") || given.key.starts_with("axes."), of_triangles = given.key.starts_with("triangles.");
    if (given.key == "triangles.area") continue;  // 50 million keys: 200 MB, larger than this cache
    const auto found = read(other);
    EXPECT_EQ(found->scenes_from_cache, !of_scenes) << given.key;
    EXPECT_EQ(found->triangles_from_cache, !of_scenes && !of_triangles) << given.key;
  }
  SurveyCacheOptions other_build = options();
  other_build.program = "build 2";
  EXPECT_FALSE(SurveyReader(other_build, 1).read(walk(), plain, true)->scenes_from_cache);
  EXPECT_TRUE(read(plain)->triangles_from_cache);
}

TEST_F(SurveyReaderTest, NothingIsKeptOfFilesThatChangedAMomentAgoOrLieInTheFuture) {
  SurveyCacheOptions now = options();
  const std::int64_t changed_ns = frame_folder_stamp(walk())->newest_ns;
  for (const std::int64_t later_ns : {-1'000'000'000LL, 0LL, 1'000'000'000LL}) {
    now.now_ns = [=] { return changed_ns + later_ns; };
    ASSERT_TRUE(SurveyReader(now, 1).read(walk(), {}, true));
    EXPECT_EQ(kept(), 0U);
  }
  now.now_ns = [=] { return changed_ns + 3'000'000'000LL; };
  ASSERT_TRUE(SurveyReader(now, 1).read(walk(), {}, true));
  EXPECT_EQ(kept(), 2U);
}

TEST_F(SurveyReaderTest, NothingIsKeptWhenAFileChangesWhileItIsRead) {
  SurveyCacheOptions changing = options();
  int calls = 0;
  changing.now_ns = [&] {
    if (++calls == 2) write_frame(5, 26, 0.5);  // the clock is asked before reading and before keeping
    return an_hour_from_now_ns();
  };
  ASSERT_TRUE(SurveyReader(changing, 1).read(walk(), {}, true));
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(kept(), 0U);
}

TEST_F(SurveyReaderTest, SaysWhatIsWrongWithAFolderAndKeepsNothingOfIt) {
  const auto nowhere = SurveyReader(options(), 1).read(walk() + "/nowhere", {}, true);
  EXPECT_FALSE(nowhere);
  EXPECT_EQ(nowhere.issues, read_frame_folder(walk() + "/nowhere").issues);
  for (int n = 0; n < frame_count; ++n) write_frame(n, 0);
  const auto empty = SurveyReader(options(), 1).read(walk(), {}, true);
  EXPECT_FALSE(empty);
  EXPECT_EQ(empty.issues, read_frame_folder(walk()).issues);
  EXPECT_EQ(kept(), 0U);
}

}  // namespace
}  // namespace stemwise
