#include "core/treeloc/match_surveys.hpp"

#include "tests/core/treeloc/synthetic_scene.hpp"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace stemwise::treeloc {
namespace {

using ::stemwise::testing::random_stand;
using ::stemwise::testing::walk;

double angle_deg(const Eigen::Matrix3d& rotation) { return degrees(Eigen::AngleAxisd(rotation).angle()); }

/// Moves the frame of reference of a survey: its poses, not what its frames saw.
FrameSet moved(FrameSet set, const RigidTransform& new_from_old) {
  for (Frame& frame : set.frames) frame.pose.survey_from_frame = new_from_old * frame.pose.survey_from_frame;
  return set;
}

TEST(MatchSurveys, FindsTheRelativePoseOfTwoSurveysFromAnyStart) {
  const auto stand = random_stand(100.0, 450, 1);
  const FrameSet a = walk(stand, 20.0, 40, 0.03, 2);
  const RigidTransform b_from_a{rotation_from({0.1, -0.15, 2.0}), {500.0, -300.0, 40.0}};
  const FrameSet b = moved(walk(stand, 22.0, 33, 0.03, 3, 0.15), b_from_a);
  const auto constraints = match_surveys(a, b, {}, 0, {});
  ASSERT_GE(constraints.size(), 30U);
  for (const auto& c : constraints) {
    const RigidTransform off = c.a_from_b * b_from_a;  // at the frame: leverage of 500 m is not the frame's fault
    const Eigen::Vector3d here = a.frames[c.scene_a].pose.survey_from_frame.translation_m;
    EXPECT_LT((off * here - here).norm(), 0.25);
    EXPECT_LT(angle_deg(off.rotation), 0.8);
  }
}

TEST(MatchSurveys, AcceptsNothingBetweenUnrelatedOrMirroredStands) {
  const FrameSet a = walk(random_stand(100.0, 450, 1), 20.0, 40, 0.03, 2);
  const FrameSet b = walk(random_stand(100.0, 450, 9), 20.0, 20, 0.03, 3);
  EXPECT_TRUE(match_surveys(a, b, {}, 0, {}).empty());
  FrameSet mirrored = a;
  for (Frame& frame : mirrored.frames) {
    for (Stem& stem : frame.stems) stem.y_m = -stem.y_m, stem.axis->y() = -stem.axis->y();
  }
  EXPECT_TRUE(match_surveys(a, mirrored, {}, 0, {}).empty());
}

TEST(MatchSurveys, GivesTheSameAnswerAtAnyThreadCount) {
  const auto stand = random_stand(80.0, 300, 4);
  const FrameSet a = walk(stand, 15.0, 70, 0.05, 5), b = walk(stand, 16.0, 66, 0.05, 6, 0.2);
  const auto one = match_surveys(a, b, {}, 1, {}), four = match_surveys(a, b, {}, 4, {});
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].scene_a, four[i].scene_a);
    EXPECT_EQ(one[i].a_from_b, four[i].a_from_b);
    EXPECT_EQ(one[i].score, four[i].score);
  }
}

TEST(MatchSurveys, MatchesScenesCutFromGlobalListsToo) {
  const auto stand = random_stand(90.0, 400, 7);
  const RigidTransform b_from_a = RigidTransform::planar(60.0, -35.0, 2.2);
  std::vector<Stem> moved_stand = stand;
  Random random(8);
  for (Stem& s : moved_stand) {
    const Eigen::Vector3d p =
        b_from_a * Eigen::Vector3d(s.x_m + random.normal(0.0, 0.03), s.y_m + random.normal(0.0, 0.03), *s.z_m);
    s.x_m = p.x();
    s.y_m = p.y();
    s.z_m = p.z();
    s.axis.reset();
  }
  const Settings method = settings_for(Method::stemwise, "auto");
  const MatchSurveysSettings settings{.most_queries = 60};
  const auto scenes_b = survey_scenes(moved_stand, method, settings, 0);
  const auto constraints = match_surveys(survey_scenes(stand, method, settings, 0), scenes_b, method, settings, 0, {});
  ASSERT_GE(constraints.size(), 35U);
  for (const auto& c : constraints) {
    EXPECT_FALSE(c.tilt_observed);
    const Eigen::Vector3d center = scenes_b[c.scene_b].survey_from_scene.translation_m;
    EXPECT_LT((c.a_from_b * center - b_from_a.inverse() * center).head<2>().norm(), 0.1);
  }
}

}  // namespace
}  // namespace stemwise::treeloc
