#include "core/survey/odometry_scale.hpp"

#include <gtest/gtest.h>

#include "core/simulate/simulate_forest.hpp"

namespace stemwise {
namespace {

FrameSet walk(double position_noise_m) {
  SimulateSettings settings;
  settings.seed = 7;
  settings.stems = 500;
  settings.dates = {date_from_civil(2020, 7, 1)};
  settings.frames = true;
  settings.position_noise_m = position_noise_m;
  return *simulate_forest(settings).surveys.front().inventory.frames;
}

TEST(OdometryScale, StepsThatAreToldTwoPercentTooShortAreFoundFromWhatNeighbouringFramesSee) {
  const FrameSet told = with_scaled_steps(walk(0.1), 1.0 / 1.02);
  const OdometryScale found = estimate_odometry_scale(told, 1);
  EXPECT_TRUE(found.significant);
  EXPECT_NEAR(found.scale, 1.02, 0.004);
  EXPECT_GE(found.links, 20);
  EXPECT_EQ(estimate_odometry_scale(told, 2).scale, found.scale) << "the same at any number of threads";
}

TEST(OdometryScale, ATrajectoryThatIsToScaleIsLeftAsItIs) { EXPECT_EQ(estimate_odometry_scale(walk(0.1), 1).scale, 1.0); }

TEST(OdometryScale, ScalingStepsKeepsTheFirstPoseAndEveryHeading) {
  const FrameSet before = walk(0.1), after = with_scaled_steps(before, 1.1);
  const auto pose = [](const FrameSet& set, std::size_t i) { return set.frames[i].pose.survey_from_frame; };
  EXPECT_EQ(pose(after, 0).translation_m, pose(before, 0).translation_m);
  for (std::size_t i = 1; i < before.frames.size(); ++i) {
    EXPECT_EQ(pose(after, i).rotation, pose(before, i).rotation);
    EXPECT_NEAR((pose(after, i).translation_m - pose(after, i - 1).translation_m).norm(), 1.1 * (pose(before, i).translation_m - pose(before, i - 1).translation_m).norm(), 1e-9);
  }
}

TEST(OdometryScale, NothingIsSaidOfAFewFrames) {
  FrameSet few = walk(0.1);
  few.frames.resize(6);
  EXPECT_FALSE(estimate_odometry_scale(few, 1).significant);
}

}  // namespace
}  // namespace stemwise
