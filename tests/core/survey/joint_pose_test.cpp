#include "core/survey/joint_pose.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.hpp"

namespace stemwise {
namespace {

RigidTransform random_pose(Random& random, double size_m, double tilt_deg) {
  return {rotation_from({radians(random.normal(0, tilt_deg)), radians(random.normal(0, tilt_deg)), random.uniform(-3, 3)}),
          {random.uniform(-size_m, size_m), random.uniform(-size_m, size_m), random.normal(0, 5)}};
}

/// `n` scenes of survey b seen in survey a, `wrong` of them nonsense.
void add_constraints(std::vector<PoseConstraint>& constraints, std::size_t a, std::size_t b, const std::vector<RigidTransform>& reference_from,
                     int n, int wrong, Random& random) {
  const RigidTransform a_from_b = reference_from[a].inverse() * reference_from[b];
  for (int i = 0; i < n; ++i) {
    PoseConstraint c{a, b, {}, {random.uniform(-200, 200), random.uniform(-50, 50), random.normal(0, 3)}, 1.0};
    const Eigen::Matrix3d turn = rotation_from({radians(random.normal(0, 0.4)), radians(random.normal(0, 0.4)), radians(random.normal(0, 0.4))});
    const Eigen::Vector3d shift(random.normal(0, 0.1), random.normal(0, 0.1), random.normal(0, 0.15));
    c.a_from_b.rotation = turn * a_from_b.rotation;
    c.a_from_b.translation_m = a_from_b * c.scene_in_b + shift - c.a_from_b.rotation * c.scene_in_b;
    if (i < wrong) c.a_from_b = random_pose(random, 300, 3);
    constraints.push_back(c);
  }
}

double off_m(const RigidTransform& a, const RigidTransform& b) {
  double most = 0.0;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(200, 0, 0), Eigen::Vector3d(-200, 50, 0), Eigen::Vector3d(0, -50, 0)})
    most = std::max(most, (a * p - b * p).norm());
  return most;
}

TEST(JointPose, FindsTheOnePoseOfTwoSurveysAmongMostlyWrongConstraints) {
  Random random(1);
  const std::vector<RigidTransform> truth{RigidTransform{}, random_pose(random, 500, 8)};
  std::vector<PoseConstraint> constraints;
  add_constraints(constraints, 0, 1, truth, 60, 36, random);
  const JointPoseReport report = estimate_joint_poses(2, 0, constraints);
  ASSERT_TRUE(report.reference_from_survey[1].has_value());
  EXPECT_LT(off_m(*report.reference_from_survey[1], truth[1]), 0.3);
  ASSERT_EQ(report.pairs.size(), 1u);
  EXPECT_EQ(report.pairs[0].constraints, 60);
  EXPECT_NEAR(report.pairs[0].accepted, 24, 1);
  EXPECT_LT(report.pairs[0].second_best, 5);
}

TEST(JointPose, PlacesASurveyThatOnlyMeetsAnotherOne) {
  Random random(2);
  const std::vector<RigidTransform> truth{RigidTransform{}, random_pose(random, 500, 5), random_pose(random, 500, 5)};
  std::vector<PoseConstraint> constraints;
  add_constraints(constraints, 0, 1, truth, 40, 5, random);
  add_constraints(constraints, 2, 1, truth, 40, 5, random);
  const JointPoseReport report = estimate_joint_poses(3, 0, constraints);
  ASSERT_TRUE(report.reference_from_survey[2].has_value());
  EXPECT_LT(off_m(*report.reference_from_survey[1], truth[1]), 0.3);
  EXPECT_LT(off_m(*report.reference_from_survey[2], truth[2]), 0.6);
}

TEST(JointPose, LeavesASurveyUnplacedThatNothingConvincingConnects) {
  Random random(3);
  const std::vector<RigidTransform> truth{RigidTransform{}, random_pose(random, 500, 5)};
  std::vector<PoseConstraint> constraints;
  add_constraints(constraints, 0, 1, truth, 20, 20, random);
  const JointPoseReport report = estimate_joint_poses(2, 0, constraints);
  EXPECT_FALSE(report.reference_from_survey[1].has_value());
  EXPECT_EQ(report.pairs[0].accepted, 0);
}

TEST(JointPose, LosesNothingAtUtmScale) {
  Random random(4);
  const Eigen::Vector3d utm(512345.0, 5412345.0, 800.0);
  std::vector<RigidTransform> truth{RigidTransform{}, random_pose(random, 500, 5)};
  std::vector<PoseConstraint> constraints;
  add_constraints(constraints, 0, 1, truth, 40, 10, random);
  for (PoseConstraint& c : constraints) c.a_from_b.translation_m += utm;
  truth[1].translation_m += utm;
  const JointPoseReport report = estimate_joint_poses(2, 0, constraints);
  ASSERT_TRUE(report.reference_from_survey[1].has_value());
  EXPECT_LT(off_m(*report.reference_from_survey[1], truth[1]), 0.3);
}

TEST(JointPose, NoConstraintsPlaceOnlyTheReference) {
  const JointPoseReport report = estimate_joint_poses(2, 1, {});
  EXPECT_TRUE(report.reference_from_survey[1].has_value());
  EXPECT_FALSE(report.reference_from_survey[0].has_value());
  EXPECT_TRUE(report.pairs.empty());
}

}  // namespace
}  // namespace stemwise
