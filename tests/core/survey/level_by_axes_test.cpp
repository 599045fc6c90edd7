#include "core/survey/level_by_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {
namespace {

/// Nearly upright stems, turned by `survey_from_level`, a share of them lying anywhere, signs at random.
std::vector<Stem> leaning_stand(const Eigen::Matrix3d& survey_from_level, int n, double wild_share, std::uint64_t seed) {
  Random random(seed);
  std::vector<Stem> stems;
  for (int i = 0; i < n; ++i) {
    const double spread = random.uniform() < wild_share ? 1.0 : 0.06;
    Eigen::Vector3d axis(random.normal(0, spread), random.normal(0, spread), 1.0);
    Stem stem;
    stem.axis = (survey_from_level * axis.normalized()) * (random.uniform() < 0.5 ? -1.0 : 1.0);
    stem.number_clusters = 4;
    stems.push_back(stem);
  }
  return stems;
}

TEST(LevelByAxes, MakesATiltedStandUprightWithinAFifthOfADegreeWhateverTheSignsOfItsAxes) {
  const Eigen::Matrix3d tilt = rotation_from({radians(10), radians(-7), 0});
  const Levelling level = level_by_axes(leaning_stand(tilt, 2000, 0.1, 1));
  ASSERT_TRUE(level.observed);
  const Eigen::Vector3d up = level.level_from_survey * tilt.col(2);
  EXPECT_LT(degrees(std::acos(std::min(1.0, up.z()))), 0.2);
  EXPECT_NEAR(degrees(level.tilt_rad), degrees(std::acos(tilt(2, 2))), 0.2);
}

TEST(LevelByAxes, TurnsNoMoreThanNeeded) {
  const Levelling level = level_by_axes(leaning_stand(rotation_from({radians(8), 0, 0}), 500, 0.0, 2));
  EXPECT_NEAR(degrees(roll_pitch_yaw(level.level_from_survey).yaw_rad), 0.0, 0.2);
}

TEST(LevelByAxes, WithoutAxesIsIdentityAndUnobserved) {
  const std::vector<Stem> stems(50);
  const Levelling level = level_by_axes(stems);
  EXPECT_FALSE(level.observed);
  EXPECT_EQ(level.level_from_survey, Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
}

TEST(LevelByAxes, LevellingALevelledListDoesNothing) {
  std::vector<Stem> stems = leaning_stand(rotation_from({radians(-9), radians(4), 0}), 300, 0.05, 4);
  const Eigen::Matrix3d first = level_by_axes(stems).level_from_survey;
  for (Stem& stem : stems) stem.axis = first * *stem.axis;
  EXPECT_TRUE(level_by_axes(stems).level_from_survey.isApprox(Eigen::Matrix3d::Identity(), 1e-6));
}

TEST(LevelByAxes, PrefersWellObservedStems) {
  std::vector<Stem> stems = leaning_stand(rotation_from({radians(10), 0, 0}), 100, 0.0, 5);
  std::vector<Stem> poor = leaning_stand(rotation_from({radians(-20), 0, 0}), 400, 0.0, 6);
  for (Stem& stem : poor) stem.reconstructed = false;
  stems.insert(stems.end(), poor.begin(), poor.end());
  EXPECT_NEAR(degrees(level_by_axes(stems).tilt_rad), 10.0, 1.0);
}

}  // namespace
}  // namespace stemwise
