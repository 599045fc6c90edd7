#include "core/treeloc/perturb_frames.hpp"

#include "tests/core/treeloc/synthetic_scene.hpp"
#include <gtest/gtest.h>

#include "core/treeloc/evaluate.hpp"
#include "core/treeloc/prepare_scene.hpp"

namespace stemwise::treeloc {
namespace {

using ::stemwise::testing::random_stand;
using ::stemwise::testing::walk;

std::size_t stems_in(const FrameSet& set) {
  std::size_t count = 0;
  for (const Frame& frame : set.frames) count += frame.stems.size();
  return count;
}

TEST(PerturbFrames, DeletesTheShareThatIsAskedForAndTheSameTreesForTheSameSeed) {
  const FrameSet frames = walk(random_stand(100.0, 450, 1), 20.0, 30, 0.0, 2);
  const auto all = static_cast<double>(stems_in(frames));
  EXPECT_EQ(stems_in(delete_trees(frames, 0.0, 3)), stems_in(frames));
  const FrameSet half = delete_trees(frames, 0.5, 3), again = delete_trees(frames, 0.5, 3), other = delete_trees(frames, 0.5, 4);
  EXPECT_NEAR(static_cast<double>(stems_in(half)) / all, 0.5, 0.03);
  bool differs = false;
  for (std::size_t i = 0; i < frames.frames.size(); ++i) {
    EXPECT_EQ(half.frames[i].stems, again.frames[i].stems);
    EXPECT_EQ(half.frames[i].pose.survey_from_frame, frames.frames[i].pose.survey_from_frame);
    differs = differs || half.frames[i].stems != other.frames[i].stems;
  }
  EXPECT_TRUE(differs);
}

TEST(PerturbFrames, NoiseHasTheSizeThatIsAskedForAndTouchesNothingElse) {
  const FrameSet frames = walk(random_stand(100.0, 450, 1), 20.0, 30, 0.0, 2);
  const FrameSet moved = add_noise(frames, 0.05, 0.0, 3), thicker = add_noise(frames, 0.0, 0.03, 3);
  double moved_sq = 0.0, thicker_sq = 0.0;
  for (std::size_t i = 0; i < frames.frames.size(); ++i) {
    for (std::size_t s = 0; s < frames.frames[i].stems.size(); ++s) {
      const Stem &was = frames.frames[i].stems[s], &m = moved.frames[i].stems[s], &t = thicker.frames[i].stems[s];
      moved_sq += std::pow(m.x_m - was.x_m, 2) + std::pow(m.y_m - was.y_m, 2);
      thicker_sq += std::pow(*t.dbh_m - *was.dbh_m, 2);
      EXPECT_EQ(m.dbh_m, was.dbh_m);
      EXPECT_EQ(m.z_m, was.z_m);
      EXPECT_EQ(t.x_m, was.x_m);
    }
  }
  const auto n = static_cast<double>(stems_in(frames));
  EXPECT_NEAR(std::sqrt(moved_sq / (2.0 * n)), 0.05, 0.003);
  EXPECT_NEAR(std::sqrt(thicker_sq / n), 0.03, 0.003);
}

TEST(PerturbFrames, ATurnedSensorSeesTheSameTreesInTheSurvey) {
  const FrameSet frames = walk(random_stand(100.0, 450, 1), 20.0, 5, 0.0, 2);
  const FrameSet turned = rotate_frames(frames, {0.6, -1.2, 2.5});
  for (std::size_t i = 0; i < frames.frames.size(); ++i) {
    for (std::size_t s = 0; s < frames.frames[i].stems.size(); ++s) {
      const Stem &was = frames.frames[i].stems[s], &is = turned.frames[i].stems[s];
      const Eigen::Vector3d before = frames.frames[i].pose.survey_from_frame * Eigen::Vector3d(was.x_m, was.y_m, *was.z_m);
      const Eigen::Vector3d after = turned.frames[i].pose.survey_from_frame * Eigen::Vector3d(is.x_m, is.y_m, *is.z_m);
      EXPECT_LT((before - after).norm(), 1e-9);
      EXPECT_GT((Eigen::Vector3d(is.x_m, is.y_m, *is.z_m) - Eigen::Vector3d(was.x_m, was.y_m, *was.z_m)).norm(), 0.01);
    }
  }
}

TEST(PerturbFrames, AMapTurnedByAnyAngleIsStillRecognised) {
  const auto stand = random_stand(100.0, 450, 1);
  const Settings settings = settings_for(Method::stemwise, "auto");
  const FrameSet map = walk(stand, 20.0, 60, 0.03, 2);
  const auto queries = prepare_frame_scenes(walk(stand, 20.5, 20, 0.03, 3, 0.1), settings.scene, settings.axes, 0);
  for (const RollPitchYaw& turn : {RollPitchYaw{0, 0, radians(-150)}, RollPitchYaw{radians(45), radians(45), 0}, RollPitchYaw{radians(75), radians(75), 0},
                                   RollPitchYaw{radians(90), radians(90), 0}, RollPitchYaw{radians(-90), radians(-90), 0}}) {
    auto scenes = prepare_frame_scenes(rotate_frames(map, turn), settings.scene, settings.axes, 0);
    const Evaluation e = evaluate_inter(queries, std::move(scenes), {}, settings, {}, 0, {});
    EXPECT_EQ(e.retrieval.recall_at_1, 1.0) << degrees(turn.roll_rad) << " " << degrees(turn.yaw_rad);
    EXPECT_GE(e.pose_3d.r50, 0.95) << degrees(turn.roll_rad) << " " << degrees(turn.yaw_rad);
  }
}

}  // namespace
}  // namespace stemwise::treeloc
