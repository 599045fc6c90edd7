#include "core/treeloc/sensor_height.hpp"

#include "tests/core/treeloc/synthetic_scene.hpp"
#include <gtest/gtest.h>

#include "core/treeloc/evaluate.hpp"
#include "core/treeloc/prepare_scene.hpp"

namespace stemwise::treeloc {
namespace {

using ::stemwise::testing::frame_of;
using ::stemwise::testing::random_stand;

/// A walk on a circle, the sensor at `height_m(i)` above the ground; base heights of frame i all off by `bias_m(i)`.
template <class Height, class Bias>
FrameSet walk_at(const std::vector<Stem>& stand, int frames, std::uint64_t seed, Height height_m, Bias bias_m) {
  FrameSet set;
  for (int i = 0; i < frames; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / frames, x = 15.0 * std::cos(angle), y = 15.0 * std::sin(angle);
    const RigidTransform pose{rotation_from({0.0, 0.0, 0.7 * i}), {x, y, height_m(i) + 0.05 * x - 0.02 * y}};
    Frame frame = frame_of(stand, pose, 20.0, 0.02, i, seed);
    for (Stem& stem : frame.stems) stem.z_m = *stem.z_m + bias_m(i);
    set.frames.push_back(std::move(frame));
  }
  return set;
}
double carried(int) { return 1.5; }
double no_bias(int) { return 0.0; }
double varying(int i) { return 1.0 + static_cast<double>(i % 7); }

std::vector<Scene> scenes_of(const FrameSet& set) { return prepare_frame_scenes(set, {}, {}, 1); }

TEST(SensorHeight, IsConstantForACarriedSensorEvenWhereBaseHeightsOfAStretchAreBiasedByMetres) {
  const auto stand = random_stand(90.0, 400, 1);
  const auto plain = sensor_height(scenes_of(walk_at(stand, 40, 2, carried, no_bias)), {});
  EXPECT_TRUE(plain.is_constant);
  EXPECT_NEAR(plain.median_m, 1.5, 0.2);
  EXPECT_LT(plain.spread_m, 0.3);
  const auto stretch = [](int i) { return i >= 30 ? -4.0 : 0.0; };  // a quarter of the way
  const auto biased = sensor_height(scenes_of(walk_at(stand, 40, 2, carried, stretch)), {});
  EXPECT_TRUE(biased.is_constant);
  EXPECT_NEAR(biased.median_m, 1.5, 0.3);
}

TEST(SensorHeight, IsNotConstantForAVaryingAHighOrAHardlyObservedOne) {
  const auto stand = random_stand(90.0, 400, 1);
  EXPECT_FALSE(sensor_height(scenes_of(walk_at(stand, 40, 2, varying, no_bias)), {}).is_constant);
  EXPECT_FALSE(sensor_height(scenes_of(walk_at(stand, 40, 2, [](int) { return 40.0; }, no_bias)), {}).is_constant);
  EXPECT_FALSE(sensor_height(scenes_of(walk_at(stand, 8, 2, carried, no_bias)), {}).is_constant) << "too few frames";
  FrameSet flat = walk_at(stand, 40, 2, carried, no_bias);
  for (Frame& frame : flat.frames) {
    for (Stem& stem : frame.stems) stem.z_m.reset();
  }
  const auto unknown = sensor_height(scenes_of(flat), {});
  EXPECT_FALSE(unknown.is_constant);
  EXPECT_EQ(unknown.frames, 0);
}

TEST(SensorHeight, MarksTheScenesOfASurveyAndNoneCutFromAList) {
  const auto stand = random_stand(90.0, 400, 1);
  for (const Scene& scene : scenes_of(walk_at(stand, 20, 2, carried, no_bias))) EXPECT_TRUE(scene.level_sensor);
  for (const Scene& scene : scenes_of(walk_at(stand, 20, 2, varying, no_bias))) EXPECT_FALSE(scene.level_sensor);
  for (const Scene& scene : prepare_grid_scenes(stand, 10.0, 10, {}, {}, 1)) EXPECT_FALSE(scene.level_sensor);
}

/// Mean height error of queries against a map.
double height_error_m(const FrameSet& map, const FrameSet& queries, bool force_level) {
  const Settings settings = settings_for(Method::stemwise, "auto");
  auto scenes = scenes_of(map), asked = scenes_of(queries);
  for (auto* list : {&scenes, &asked}) {
    for (Scene& scene : *list) scene.level_sensor = scene.level_sensor || force_level;
  }
  const auto localizer = make_localizer(settings);
  localizer->add(scenes, 1);
  const auto found = localize_all(*localizer, asked, {}, 1, {});
  double sum = 0.0;
  for (std::size_t q = 0; q < asked.size(); ++q) {
    const Candidate& best = found[q].candidates.at(0);
    const RigidTransform truth = scenes[best.scene].survey_from_scene.inverse() * asked[q].survey_from_scene;
    sum += std::abs(best.candidate_from_query.translation_m.z() - truth.translation_m.z()) / static_cast<double>(asked.size());
  }
  return sum;
}

TEST(HeightPrior, AppliesWhereTheSensorWasCarriedLevelAndOnlyThere) {
  const auto stand = random_stand(90.0, 400, 1);
  const auto slow_bias = [](int i) { return 0.5 * std::sin(0.5 * i); };
  const FrameSet map = walk_at(stand, 40, 2, carried, no_bias);
  const FrameSet level = walk_at(stand, 25, 3, carried, slow_bias);
  EXPECT_LT(height_error_m(map, level, false), 0.15) << "base heights are off by up to half a metre, the sensor was not";
  const FrameSet raised = walk_at(stand, 25, 3, varying, no_bias);
  EXPECT_LT(height_error_m(map, raised, false), 0.15) << "no prior: the base heights are believed";
  EXPECT_GT(height_error_m(map, raised, true), 0.3) << "with it a raised sensor would be pulled down";
}

}  // namespace
}  // namespace stemwise::treeloc
