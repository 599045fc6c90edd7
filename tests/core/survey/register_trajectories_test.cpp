#include "core/survey/register_trajectories.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/random.hpp"
#include "core/simulate/drift.hpp"
#include "core/simulate/simulate_forest.hpp"
#include "core/survey/build_global_inventory.hpp"

namespace stemwise {
namespace {

RigidTransform pose(double x, double y, double z, double yaw) { return {rotation_from({0.0, 0.0, yaw}), {x, y, z}}; }

/// A square walked twice: odometry too long by 5 %, and loops between both rounds.
struct Square {
  std::vector<RigidTransform> truth, drifted;
  std::vector<PoseEdge> edges;
};

Square square_walk() {
  Square walk;
  constexpr std::size_t per_side = 10, round = 4 * per_side;
  for (std::size_t i = 0; i < 2 * round; ++i) {
    const auto k = static_cast<double>(i % per_side);
    const std::size_t side = i / per_side % 4;
    const double at[4][2] = {{3 * k, 0}, {30, 3 * k}, {30 - 3 * k, 30}, {0, 30 - 3 * k}};
    walk.truth.push_back(pose(at[side][0], at[side][1], 0.1 * k, 1.5707963 * static_cast<double>(side)));
  }
  walk.drifted.push_back(walk.truth[0]);
  for (std::size_t i = 1; i < walk.truth.size(); ++i) {
    RigidTransform step = walk.truth[i - 1].inverse() * walk.truth[i];
    step.translation_m *= 1.05;
    step.rotation = step.rotation * rotation_from({0, 0, 0.004});
    walk.drifted.push_back(walk.drifted.back() * step);
    walk.edges.push_back({i - 1, i, step, 0.3, 0.3, 0.02, 0.02, true});
  }
  for (std::size_t i = 0; i < round; i += 4) walk.edges.push_back({i, i + round, walk.truth[i].inverse() * walk.truth[i + round], 0.05, 0.05, 0.01, 0.01, false});
  for (std::size_t i = 5; i < round; i += 5) walk.edges.push_back({0, i, walk.truth[0].inverse() * walk.truth[i], 0.05, 0.05, 0.01, 0.01, false});
  return walk;
}

double worst_m(const std::vector<RigidTransform>& poses, const std::vector<RigidTransform>& truth) {
  double worst = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) worst = std::max(worst, (poses[i].translation_m - truth[i].translation_m).norm());
  return worst;
}

TEST(PoseGraph, TakesDriftOutByLoops) {
  const Square walk = square_walk();
  EXPECT_GT(worst_m(walk.drifted, walk.truth), 5.0);
  const PoseGraphReport report = optimise_pose_graph(walk.drifted, walk.edges, 0);
  EXPECT_LT(worst_m(report.poses, walk.truth), 0.6);
  for (const char accepted : report.accepted) EXPECT_TRUE(accepted);
  for (const std::size_t group : report.group) EXPECT_EQ(group, 0u);
}

TEST(PoseGraph, RejectsAWrongLoopAndSaysHowFarOffItIs) {
  Square walk = square_walk();
  walk.edges.push_back({3, 27, pose(0, 0, 0, 0), 0.05, 0.05, 0.01, 0.01, false});
  const PoseGraphReport report = optimise_pose_graph(walk.drifted, walk.edges, 0);
  EXPECT_FALSE(report.accepted.back());
  EXPECT_GT(report.residual_m.back(), 20.0);
  EXPECT_LT(worst_m(report.poses, walk.truth), 0.6);
}

TEST(PoseGraph, SaysWhatNothingConnects) {
  const std::vector<RigidTransform> start{pose(0, 0, 0, 0), pose(1, 0, 0, 0), pose(50, 0, 0, 0), pose(51, 0, 0, 0)};
  const std::vector<PoseEdge> edges{{0, 1, pose(1.2, 0, 0, 0), 0.1, 0.1, 0.01, 0.01, true}, {2, 3, pose(1.2, 0, 0, 0), 0.1, 0.1, 0.01, 0.01, true}};
  const PoseGraphReport report = optimise_pose_graph(start, edges, 0);
  EXPECT_EQ(report.group[1], 0u);
  EXPECT_NE(report.group[2], 0u);
  EXPECT_EQ(report.group[2], report.group[3]);
  EXPECT_NEAR(report.poses[3].translation_m.x(), 51.2, 1e-6);
}

TEST(WithDrift, MovesTheEndByAboutThatShareOfTheWay) {
  FrameSet frames;
  for (int i = 0; i <= 100; ++i) frames.frames.push_back({i, {static_cast<double>(i), pose(2.0 * i, 0, 0, 0)}, {}});
  const FrameSet drifted = with_drift(frames, 0.02, 1);
  EXPECT_EQ(drifted.frames[0].pose.survey_from_frame, frames.frames[0].pose.survey_from_frame);
  const double off = (drifted.frames[100].pose.survey_from_frame.translation_m - frames.frames[100].pose.survey_from_frame.translation_m).norm();
  EXPECT_GT(off, 0.6 * 0.02 * 200.0);
  EXPECT_LT(off, 1.5 * 0.02 * 200.0);
}

/// Root mean square distance of a trajectory from the truth, after the best rigid fit of its positions in the plane.
double drift_m(const FrameSet& frames, const FrameSet& truth) {
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
  const auto n = static_cast<double>(frames.frames.size());
  const auto at = [](const FrameSet& set, std::size_t i) -> Eigen::Vector2d { return set.frames[i].pose.survey_from_frame.translation_m.head<2>(); };
  for (std::size_t i = 0; i < frames.frames.size(); ++i) from += at(frames, i) / n, to += at(truth, i) / n;
  double dot = 0.0, cross = 0.0, sum_sq = 0.0;
  for (std::size_t i = 0; i < frames.frames.size(); ++i) {
    const Eigen::Vector2d u = at(frames, i) - from, v = at(truth, i) - to;
    dot += u.dot(v), cross += u.x() * v.y() - u.y() * v.x();
  }
  const Eigen::Rotation2D<double> turn(std::atan2(cross, dot));
  for (std::size_t i = 0; i < frames.frames.size(); ++i) sum_sq += (turn * (at(frames, i) - from) - (at(truth, i) - to)).squaredNorm();
  return std::sqrt(sum_sq / n);
}

TEST(RegisterTrajectories, LaysADriftingWalkOntoABareList) {
  SimulateSettings settings;
  settings.stems = 350;
  settings.frames = true;
  settings.drop = 0.2;
  settings.position_noise_m = 0.15;
  settings.dates = {date_from_civil(2015, 7, 1), date_from_civil(2019, 7, 1)};
  const SimulatedForest forest = simulate_forest(settings);
  std::vector<Inventory> surveys{forest.surveys[0].inventory, forest.surveys[1].inventory};
  surveys[1].frames.reset();
  for (Stem& stem : surveys[1].stems) stem.z_m.reset(), stem.axis.reset();
  const FrameSet truth = *surveys[0].frames;
  surveys[0].frames = std::make_shared<const FrameSet>(with_drift(truth, 0.03, 2));
  surveys[0].stems.clear();
  const double before_m = drift_m(*surveys[0].frames, truth);
  const RegisterReport report = register_trajectories(surveys, {}, 2, {});
  ASSERT_TRUE(report.corrected[0]);
  EXPECT_FALSE(report.corrected[1]);
  EXPECT_GT(before_m, 1.0);
  EXPECT_LT(drift_m(*report.corrected[0], truth), 0.15);
  EXPECT_EQ(report.group[0], report.group[1]);
}

TEST(RegisterTrajectories, LeavesATrajectoryThatDoesNotDriftAsItIs) {
  SimulateSettings settings;
  settings.stems = 250;
  settings.frames = true;
  settings.dates = {date_from_civil(2015, 7, 1), date_from_civil(2019, 7, 1)};
  const SimulatedForest forest = simulate_forest(settings);
  std::vector<Inventory> surveys{forest.surveys[0].inventory, forest.surveys[1].inventory};
  surveys[0].stems.clear();
  surveys[1].frames.reset();
  const RegisterReport report = register_trajectories(surveys, {}, 2, {});
  EXPECT_FALSE(report.corrected[0]);
  EXPECT_LT(report.correction_m[0], 0.3);
}

}  // namespace
}  // namespace stemwise
