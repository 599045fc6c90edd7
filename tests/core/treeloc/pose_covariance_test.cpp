#include "core/treeloc/fuse_poses.hpp"
#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/pose_covariance.hpp"

#include "tests/core/treeloc/synthetic_scene.hpp"
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/treeloc/evaluate.hpp"
#include "core/treeloc/prepare_scene.hpp"
#include "core/treeloc/refine_pose.hpp"

namespace stemwise::treeloc {
namespace {

using ::stemwise::testing::frame_of;
using ::stemwise::testing::random_stand;
using ::stemwise::testing::walk;

Evaluation evaluated(Method method, double noise_m) {
  const Settings settings = settings_for(method, "auto");
  const auto stand = random_stand(100.0, 450, 1);
  auto map = prepare_frame_scenes(walk(stand, 20.0, 60, noise_m, 2), settings.scene, settings.axes, 0);
  auto queries = prepare_frame_scenes(walk(stand, 20.5, 80, noise_m, 3, 0.1), settings.scene, settings.axes, 0);
  return evaluate_inter(std::move(queries), std::move(map), {}, settings, {}, 0, {});
}

class CovarianceOfMethod : public ::testing::TestWithParam<Method> {};

TEST_P(CovarianceOfMethod, HoldsTheTruthInsideIts95PercentRegionAboutAsOftenAsItSays) {
  for (const double noise_m : {0.02, 0.06}) {
    const Evaluation e = evaluated(GetParam(), noise_m);
    ASSERT_GT(e.calibration.poses, 60);
    EXPECT_GE(e.calibration.inside_95, 0.85) << noise_m;
    for (const QueryRow& row : e.rows) {
      if (!row.found()) continue;
      const Eigen::SelfAdjointEigenSolver<PoseCovariance> solver(row.covariance);
      EXPECT_GT(solver.eigenvalues().minCoeff(), 0.0);
      EXPECT_LT(std::sqrt(row.covariance(0, 0)), 0.5) << "not by being useless";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, CovarianceOfMethod, ::testing::Values(Method::stemwise, Method::treelocpp),
                         [](const auto& method) { return method.param == Method::stemwise ? "stemwise" : "published"; });

/// Two views of one spot, and the pairs of their trees.
struct TwoViews {
  Scene query, candidate;
  std::vector<TreePair> pairs;
  RigidTransform candidate_from_query;
};
TwoViews two_views(double candidate_yaw_rad, bool with_heights_and_axes, double noise_m = 0.03) {
  const auto stand = random_stand(40.0, 60, 4);
  FrameSet set;
  set.frames.push_back(frame_of(stand, {rotation_from({0.0, 0.0, 0.4}), {1.0, 0.5, 1.5}}, 20.0, noise_m, 0, 5));
  set.frames.push_back(frame_of(stand, {rotation_from({0.0, 0.0, candidate_yaw_rad}), {0.0, 0.0, 1.5}}, 20.0, noise_m, 1, 5));
  for (Frame& frame : set.frames) {
    for (Stem& stem : frame.stems) {
      if (!with_heights_and_axes) stem.z_m.reset(), stem.axis.reset();
    }
  }
  TwoViews views{prepare_frame_scene(set, 0, {}, {}), prepare_frame_scene(set, 1, {}, {}), {}, {}};
  views.candidate_from_query = views.candidate.survey_from_scene.inverse() * views.query.survey_from_scene;
  PlanarTreeStore store;
  store.add(views.query);
  store.add(views.candidate);
  TreeMatcher matcher({});
  const RigidTransform aligned{
      views.candidate.aligned_from_scene * views.candidate_from_query.rotation * views.query.aligned_from_scene.transpose(),
      views.candidate.aligned_from_scene * views.candidate_from_query.translation_m};
  matcher.pair(store.trees(0), store.trees(1), planar_part(aligned), 0.4);
  views.pairs.assign(matcher.pairs().begin(), matcher.pairs().end());
  return views;
}

TEST(PoseCovariance, GrowsWithTheResiduals) {
  const TwoViews fine = two_views(0.3, true, 0.02), coarse = two_views(0.3, true, 0.12);
  const auto a = pair_covariance(fine.query, fine.candidate, fine.pairs, fine.candidate_from_query, {});
  const auto b = pair_covariance(coarse.query, coarse.candidate, coarse.pairs, coarse.candidate_from_query, {});
  EXPECT_GT(b(0, 0), 2.0 * a(0, 0));
  EXPECT_GT(b(5, 5), 2.0 * a(5, 5));
}

TEST(PoseCovariance, TurnsWithTheCandidatesFrame) {
  const TwoViews straight = two_views(0.0, true), turned = two_views(std::numbers::pi / 2, true);
  const auto a = pair_covariance(straight.query, straight.candidate, straight.pairs, straight.candidate_from_query, {});
  const auto b = pair_covariance(turned.query, turned.candidate, turned.pairs, turned.candidate_from_query, {});
  // x of the turned frame is y of the straight one.
  EXPECT_NEAR(b(0, 0) / a(1, 1), 1.0, 0.15);
  EXPECT_NEAR(b(1, 1) / a(0, 0), 1.0, 0.15);
  EXPECT_NEAR(b(3, 3) / a(4, 4), 1.0, 0.15);
}

TEST(PoseCovariance, SaysThatHeightIsUnknownWithoutBaseHeightsAndTiltNoBetterThanItsPrior) {
  const TwoViews known = two_views(0.3, true), flat = two_views(0.3, false);
  const auto a = pair_covariance(known.query, known.candidate, known.pairs, known.candidate_from_query, {});
  const auto b = pair_covariance(flat.query, flat.candidate, flat.pairs, flat.candidate_from_query, {});
  EXPECT_LT(std::sqrt(a(2, 2)), 0.2);
  EXPECT_GT(std::sqrt(b(2, 2)), 10.0);
  EXPECT_LT(degrees(std::sqrt(a(3, 3))), 0.5);
  EXPECT_NEAR(degrees(std::sqrt(b(3, 3))), 1.0, 0.1);
}

TEST(PoseCovariance, MahalanobisDistanceIsThatOfTheDefinition) {
  PoseCovariance covariance = PoseCovariance::Identity() * 0.04;
  const RigidTransform estimate{rotation_from({0.2, -0.1, 1.0}), {3.0, 4.0, 5.0}};
  RigidTransform truth = estimate;
  truth.translation_m.x() += 0.4;
  EXPECT_NEAR(mahalanobis_sq(estimate, covariance, truth), 4.0, 1e-9);
  truth.rotation = Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitZ()).toRotationMatrix() * truth.rotation;
  EXPECT_NEAR(mahalanobis_sq(estimate, covariance, truth), 5.0, 1e-9);
}

}  // namespace
}  // namespace stemwise::treeloc
