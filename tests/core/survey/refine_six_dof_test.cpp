#include "core/survey/refine_six_dof.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.hpp"

namespace stemwise {
namespace {

struct Noise {
  double planar_m = 0.1, height_m = 0.2, axis_rad = 0.05, wrong_share = 0.15;
};

struct Surveys {
  std::vector<Stem> reference, query;
  std::vector<IndexPair> pairs;
  RigidTransform reference_from_query;  ///< the truth
};

/// A stand of `half_m` around `middle`, seen twice; the second survey in a frame of its own.
Surveys two_surveys(const RigidTransform& reference_from_query, double half_m, int n, const Noise& noise, std::uint64_t seed,
                    const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  Random random(seed);
  Surveys s;
  s.reference_from_query = reference_from_query;
  const RigidTransform query_from_reference = reference_from_query.inverse();
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d at = middle + Eigen::Vector3d(random.uniform(-half_m, half_m), random.uniform(-half_m, half_m), random.normal(0, 3));
    const Eigen::Vector3d axis = Eigen::Vector3d(random.normal(0, 0.06), random.normal(0, 0.06), 1.0).normalized();
    Stem a;
    a.x_m = at.x();
    a.y_m = at.y();
    a.z_m = at.z();
    a.axis = axis;
    Eigen::Vector3d seen = at + Eigen::Vector3d(random.normal(0, noise.planar_m), random.normal(0, noise.planar_m), random.normal(0, noise.height_m));
    if (random.uniform() < noise.wrong_share) seen += Eigen::Vector3d(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-5, 5));
    const Eigen::Vector3d q = query_from_reference * seen;
    Stem b;
    b.x_m = q.x();
    b.y_m = q.y();
    b.z_m = q.z();
    b.axis = query_from_reference.rotation * (axis + Eigen::Vector3d(random.normal(0, noise.axis_rad), random.normal(0, noise.axis_rad), 0)).normalized();
    s.reference.push_back(a);
    s.query.push_back(b);
    s.pairs.push_back({static_cast<std::size_t>(i), static_cast<std::size_t>(i)});
  }
  return s;
}

RigidTransform tilted_pose(const Eigen::Vector3d& shift) { return {rotation_from({radians(10), radians(-10), radians(137)}), shift}; }

/// The truth spoilt by as much as a planar alignment of levelled lists leaves.
RigidTransform rough(const RigidTransform& truth, const Eigen::Vector3d& about) {
  const Eigen::Matrix3d turn = rotation_from({radians(1.5), radians(-2), radians(1)});
  return {turn * truth.rotation, turn * (truth.translation_m - about) + about + Eigen::Vector3d(0.4, -0.3, 7.0)};
}

double rms_m(const Surveys& s, const RigidTransform& found) {
  double sum = 0.0;
  for (const Stem& stem : s.query) {
    const Eigen::Vector3d p(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
    sum += (found * p - s.reference_from_query * p).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(s.query.size()));
}

TEST(RefineSixDof, RecoversAllSixFromATiltedSurveyWithWrongPairs) {
  const Surveys s = two_surveys(tilted_pose({300, -400, 20}), 150, 1500, {}, 1);
  const SixDofReport report = refine_six_dof(s.reference, s.query, s.pairs, rough(s.reference_from_query, {0, 0, 0}));
  for (const Dof dof : {Dof::x, Dof::y, Dof::yaw, Dof::z, Dof::roll, Dof::pitch}) EXPECT_TRUE(report.observed[dof]);
  EXPECT_LT(rms_m(s, report.reference_from_query), 0.05);
  EXPECT_TRUE((report.reference_from_query.rotation * report.reference_from_query.rotation.transpose()).isIdentity(1e-9));
}

TEST(RefineSixDof, LosesNothingAtUtmScale) {
  const Eigen::Vector3d utm(512345.0, 5412345.0, 800.0);
  const auto rms_at = [](const Eigen::Vector3d& middle) {
    const Surveys s = two_surveys(tilted_pose({1, 2, 3}), 60, 400, {}, 2, middle);
    return rms_m(s, refine_six_dof(s.reference, s.query, s.pairs, rough(s.reference_from_query, middle)).reference_from_query);
  };
  EXPECT_NEAR(rms_at(utm), rms_at(Eigen::Vector3d::Zero()), 1e-4);
  EXPECT_LT(rms_at(utm), 0.15);
}

TEST(RefineSixDof, ExactDataGivesTheExactPose) {
  const Surveys s = two_surveys(tilted_pose({10, 20, 3}), 30, 60, {0, 0, 0, 0}, 3);
  const SixDofReport report = refine_six_dof(s.reference, s.query, s.pairs, rough(s.reference_from_query, {0, 0, 0}));
  EXPECT_LT(rms_m(s, report.reference_from_query), 1e-4);
}

TEST(RefineSixDof, SwappingTheListsInvertsThePose) {
  const Surveys s = two_surveys(tilted_pose({100, 20, 3}), 100, 800, {}, 4);
  const RigidTransform there = refine_six_dof(s.reference, s.query, s.pairs, rough(s.reference_from_query, {0, 0, 0})).reference_from_query;
  const RigidTransform back = refine_six_dof(s.query, s.reference, s.pairs, there.inverse()).reference_from_query;
  const RigidTransform round = there * back;
  EXPECT_LT(round.translation_m.norm(), 0.5);
  EXPECT_LT(degrees(std::acos(std::min(1.0, (round.rotation.trace() - 1) / 2))), 0.3);
}

TEST(RefineSixDof, WithoutHeightsAndAxesOnlyThePlaneIsObservedAndTheRestIsZero) {
  Surveys s = two_surveys(RigidTransform::planar(50, -20, 1.1), 50, 200, {}, 5);
  for (Stem& stem : s.query) {
    stem.z_m.reset();
    stem.axis.reset();
  }
  const SixDofReport report = refine_six_dof(s.reference, s.query, s.pairs, RigidTransform::planar(50.3, -20.2, 1.11));
  EXPECT_TRUE(report.observed[Dof::x]);
  EXPECT_FALSE(report.observed[Dof::z]);
  EXPECT_FALSE(report.observed[Dof::roll]);
  const RigidTransform& t = report.reference_from_query;
  EXPECT_EQ(t.translation_m.z(), 0.0);
  EXPECT_NEAR(roll_pitch_yaw(t.rotation).roll_rad, 0.0, 1e-12);
  EXPECT_LT((t * Eigen::Vector3d(0, 0, 0) - s.reference_from_query * Eigen::Vector3d(0, 0, 0)).head<2>().norm(), 0.05);
}

TEST(RefineSixDof, HeightsOverAWidePlaneGiveTheTiltWithoutAnyAxis) {
  Surveys s = two_surveys({rotation_from({radians(1), radians(-1.5), radians(40)}), {5, 6, 7}}, 100, 500, {}, 6);
  for (Stem& stem : s.reference) stem.axis.reset();
  const SixDofReport report = refine_six_dof(s.reference, s.query, s.pairs, RigidTransform::planar(5, 6, radians(40)));
  EXPECT_TRUE(report.observed[Dof::roll]);
  EXPECT_EQ(report.axis_pairs, 0);
  EXPECT_LT(rms_m(s, report.reference_from_query), 0.15);
}

TEST(RefineSixDof, ATinyPlotWithoutAxesDoesNotClaimATilt) {
  Surveys s = two_surveys(RigidTransform::planar(5, 6, 0.3), 3, 12, {}, 7);
  for (Stem& stem : s.reference) stem.axis.reset();
  const SixDofReport report = refine_six_dof(s.reference, s.query, s.pairs, RigidTransform::planar(5, 6, 0.3));
  EXPECT_FALSE(report.observed[Dof::pitch]);
  EXPECT_TRUE(report.observed[Dof::z]);
}

TEST(RefineSixDof, FewerThanTwoPairsLeaveTheGuessAndSaySo) {
  const Surveys s = two_surveys(RigidTransform::planar(5, 6, 0.3), 3, 1, {}, 8);
  const SixDofReport report = refine_six_dof(s.reference, s.query, s.pairs, RigidTransform::planar(1, 2, 3));
  EXPECT_EQ(report.reference_from_query, RigidTransform::planar(1, 2, 3));
  EXPECT_FALSE(report.observed[Dof::x]);
  EXPECT_FALSE(report.notes.empty());
}

}  // namespace
}  // namespace stemwise
