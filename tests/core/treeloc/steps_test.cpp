#include <algorithm>
#include <numeric>
#include <set>

#include "tests/core/treeloc/synthetic_scene.hpp"
#include <gtest/gtest.h>

#include "core/treeloc/align_axes.hpp"
#include "core/treeloc/assignment.hpp"
#include "core/treeloc/correct_vertical.hpp"
#include "core/treeloc/overlap_score.hpp"
#include "core/treeloc/pairwise_distance_histogram.hpp"
#include "core/treeloc/planar_pose.hpp"
#include "core/treeloc/prepare_scene.hpp"
#include "core/treeloc/retrieve_scenes.hpp"
#include "core/treeloc/tree_distribution_histogram.hpp"
#include "core/treeloc/triangles.hpp"

namespace stemwise::treeloc {
namespace {

using ::stemwise::testing::random_stand;

/// The scene of a stand turned by `yaw` about its origin, mirrored in y where asked.
Scene scene_of(std::vector<Stem> stems, double yaw_rad, bool mirror = false) {
  const RigidTransform turn = RigidTransform::planar(0.0, 0.0, yaw_rad);
  FrameSet set;
  set.frames.push_back({0, {}, {}});
  for (Stem& s : stems) {
    const Eigen::Vector3d p = turn * Eigen::Vector3d(s.x_m, mirror ? -s.y_m : s.y_m, *s.z_m);
    s.x_m = p.x();
    s.y_m = p.y();
    s.axis = Eigen::Vector3d::UnitZ();
  }
  set.frames[0].stems = std::move(stems);
  return prepare_frame_scene(set, 0, {}, {});
}

std::multiset<std::uint32_t> keys_of(const Scene& scene, const TriangleSettings& settings) {
  TriangleMaker maker(settings);
  std::multiset<std::uint32_t> keys;
  for (const Triangle& t : maker.make(scene)) keys.insert(t.key);
  return keys;
}

std::size_t shared(const std::multiset<std::uint32_t>& a, const std::multiset<std::uint32_t>& b) {
  std::vector<std::uint32_t> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both.size();
}

TEST(Triangles, KeysSurviveATurnButNotAMirror) {
  const auto stand = random_stand(30.0, 40, 1);
  const auto keys = keys_of(scene_of(stand, 0.0), {}), turned = keys_of(scene_of(stand, 1.1), {}),
             mirrored = keys_of(scene_of(stand, 1.1, true), {});
  EXPECT_EQ(keys.size(), turned.size());
  EXPECT_GE(shared(keys, turned), keys.size() * 95 / 100);  // a side on the edge of a step may fall either way
  EXPECT_LE(shared(keys, mirrored), keys.size() / 10);
}

TEST(Triangles, EveryTripleIsMadeOnce) {
  TriangleMaker maker({});
  std::set<std::set<int>> triples;
  const Scene scene = scene_of(random_stand(30.0, 40, 2), 0.3);
  for (const Triangle& t : maker.make(scene)) EXPECT_TRUE(triples.insert({t.tree[0], t.tree[1], t.tree[2]}).second);
  EXPECT_GT(triples.size(), 1000U);
}

TEST(Triangles, VerticesAreOrderedByTheSideOpposite) {
  TriangleMaker maker({});
  const Scene scene = scene_of(random_stand(30.0, 30, 3), 0.0);
  for (const Triangle& t : maker.make(scene)) {
    const auto at = [&](int v) -> Eigen::Vector2d { return scene.trees[t.tree[v]].position_m.head<2>(); };
    EXPECT_LE((at(1) - at(2)).norm(), (at(0) - at(2)).norm() + 1e-5);
    EXPECT_LE((at(0) - at(2)).norm(), (at(0) - at(1)).norm() + 1e-5);
  }
}

TEST(Triangles, DenseKeysAreDifferentAndInRange) {
  TriangleSettings settings;
  settings.max_side_m = 3.0;
  const TriangleKeys keys(settings);
  std::set<std::uint32_t> seen;
  for (std::uint32_t c = 0; c <= 20; ++c) {
    for (std::uint32_t b = 0; b <= c; ++b) {
      for (std::uint32_t a = c > b + 1 ? c - b - 1 : 0; a <= b; ++a) {
        for (const bool left : {false, true}) {
          EXPECT_TRUE(seen.insert(keys.key(a, b, c, 0, left)).second);
          EXPECT_LT(keys.key(a, b, c, 0, left), keys.count());
        }
      }
    }
  }
}

TEST(Triangles, ThePublishedHashIsThatOfEquation3) {
  const std::uint64_t rho = 100007, range = 50'000'000;
  const std::uint64_t sides = ((40 * rho + 30) % range * rho + 20) % range;
  EXPECT_EQ(TriangleKeys::published_hash(20, 30, 40, 7), (sides * rho + 7) % range);
}

TEST(Histograms, DoNotChangeWhenTheSceneIsTurned) {
  const auto stand = random_stand(30.0, 40, 4);
  const Scene scene = scene_of(stand, 0.0), turned = scene_of(stand, 2.0);
  const auto tdh = tree_distribution_histogram(scene, {}), tdh_turned = tree_distribution_histogram(turned, {});
  const auto pdh = pairwise_distance_histogram(scene, {}), pdh_turned = pairwise_distance_histogram(turned, {});
  EXPECT_EQ(tdh.size(), 40U);
  EXPECT_EQ(pdh.size(), 40U);
  EXPECT_LT(chi_square(tdh, tdh_turned), 0.5);
  EXPECT_LT(chi_square(pdh, pdh_turned), 2.0);
  EXPECT_EQ(chi_square(tdh, tdh), 0.0);
}

TEST(Retrieval, CountsRepeatedTrianglesBySmallerNumberOrOnce) {
  std::vector<Triangle> query(5), candidate(4);
  const std::vector<std::uint32_t> q{1, 2, 2, 2, 9}, c{2, 2, 3, 9};
  for (std::size_t i = 0; i < q.size(); ++i) query[i].key = q[i];
  for (std::size_t i = 0; i < c.size(); ++i) candidate[i].key = c[i];
  EXPECT_EQ(shared_triangles(query, candidate, true), 3);
  EXPECT_EQ(shared_triangles(query, candidate, false), 2);
}

TEST(Assignment, IsAsGoodAsTryingEveryOrder) {
  Random random(5);
  for (int round = 0; round < 40; ++round) {
    const int rows = 1 + static_cast<int>(random.below(5)), columns = 1 + static_cast<int>(random.below(5));
    std::vector<double> cost(static_cast<std::size_t>(rows * columns));
    for (double& v : cost) v = random.uniform(0.0, 10.0);
    const auto column_of = least_cost_assignment(cost, rows, columns);
    double total = 0.0;
    std::set<int> used;
    for (int r = 0; r < rows; ++r) {
      if (column_of[static_cast<std::size_t>(r)] < 0) continue;
      total += cost[static_cast<std::size_t>(r * columns + column_of[static_cast<std::size_t>(r)])];
      EXPECT_TRUE(used.insert(column_of[static_cast<std::size_t>(r)]).second);
    }
    EXPECT_EQ(static_cast<int>(used.size()), std::min(rows, columns));
    std::vector<int> order(static_cast<std::size_t>(std::max(rows, columns)));
    std::iota(order.begin(), order.end(), 0);
    double best = 1e9;
    do {
      double sum = 0.0;
      for (int i = 0; i < std::max(rows, columns); ++i) {
        const int r = rows <= columns ? i : order[static_cast<std::size_t>(i)],
                  c = rows <= columns ? order[static_cast<std::size_t>(i)] : i;
        if (r < rows && c < columns) sum += cost[static_cast<std::size_t>(r * columns + c)];
      }
      best = std::min(best, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_NEAR(total, best, 1e-9);
  }
}

TEST(PlanarPose, IsRecoveredFromPairsAndIsNeverAReflection) {
  const PlanarPose truth = PlanarPose::from_yaw(3.0, -2.0, 2.5);
  std::vector<PlanarPair> pairs;
  for (const Eigen::Vector2d& q : {Eigen::Vector2d(0, 0), Eigen::Vector2d(5, 1), Eigen::Vector2d(-2, 7)})
    pairs.push_back({q, truth * q, 1.0});
  const PlanarPose fit = fit_planar_pose(pairs);
  EXPECT_NEAR(fit.x_m, 3.0, 1e-12);
  EXPECT_NEAR(fit.yaw_rad(), 2.5, 1e-12);
  for (PlanarPair& p : pairs) p.candidate.x() = -p.candidate.x();
  const PlanarPose mirrored = fit_planar_pose(pairs);
  EXPECT_NEAR(mirrored.cosine * mirrored.cosine + mirrored.sine * mirrored.sine, 1.0, 1e-12);
}

TEST(AlignAxes, FindsTheDominantAxisWhateverTheSignsAndOutliers) {
  Random random(6);
  const Eigen::Matrix3d tilted_from_upright = rotation_from({0.3, -0.2, 0.0});
  std::vector<Eigen::Vector3d> axes;
  for (int i = 0; i < 40; ++i) {
    Eigen::Vector3d a(random.normal(0.0, 0.01), random.normal(0.0, 0.01), 1.0);
    if (i % 5 == 0) a = Eigen::Vector3d(1.0, random.normal(), 0.4);
    a = tilted_from_upright * a.normalized();
    axes.push_back(i % 2 == 0 ? a : Eigen::Vector3d(-a));
  }
  const auto aligned = align_axes(axes, {});
  ASSERT_TRUE(aligned);
  EXPECT_LT(degrees(std::acos((*aligned * tilted_from_upright.col(2)).z())), 0.6);
  EXPECT_FALSE(align_axes(std::span(axes).first(2), {}));
}

TEST(CorrectVertical, FindsHeightRollAndPitchDespiteWrongHeights) {
  Scene query = scene_of(random_stand(40.0, 40, 7), 0.0), candidate = query;
  std::vector<TreePair> pairs;
  for (std::size_t i = 0; i < query.trees.size(); ++i) {
    auto& p = candidate.trees[i].position_m;
    p.z() += 0.7 - 0.02 * p.x() + 0.01 * p.y() + (i % 6 == 0 ? 3.0 : 0.0);
    pairs.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(i), 0.0F});
  }
  const RigidTransform correction = correct_vertical(query, candidate, pairs, {}, {}, 1);
  const RollPitchYaw angles = roll_pitch_yaw(correction.rotation);
  EXPECT_NEAR(correction.translation_m.z(), 0.7, 0.02);
  EXPECT_NEAR(angles.roll_rad, 0.01, 0.002);
  EXPECT_NEAR(angles.pitch_rad, 0.02, 0.002);
}

TEST(OverlapScore, IsThatOfTheEquation) {
  EXPECT_NEAR(overlap_score(20, 30, 40, 5.0, {}), 20.0 / 50.0 * std::exp(-1.0), 1e-12);
  EXPECT_EQ(overlap_score(0, 0, 0, 0.0, {}), 0.0);
}

TEST(PrepareScene, FillsUpWithCandidateStemsBestObservedFirstAndKeepsTheBox) {
  FrameSet set;
  set.frames.push_back({0, {}, random_stand(50.0, 60, 8)});
  auto& stems = set.frames[0].stems;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    stems[i].reconstructed = i < 10;
    stems[i].number_clusters = static_cast<int>(1 + i % 4);
  }
  stems.push_back(stems[0]);
  stems.back().x_m = 31.0;
  const Scene scene = prepare_frame_scene(set, 0, {}, {});
  EXPECT_EQ(scene.trees.size(), 30U);
  EXPECT_EQ(std::count_if(scene.trees.begin(), scene.trees.end(), [](const SceneTree& t) { return t.reconstructed; }), 10);
  for (const SceneTree& t : scene.trees) {
    EXPECT_LE(std::abs(t.position_m.x()), 30.5);
    EXPECT_TRUE(t.reconstructed || t.clusters >= 3);
  }
}

TEST(PrepareScene, TakesReconstructedTreesOfPrecedingFramesOnce) {
  FrameSet set;
  const auto stand = random_stand(30.0, 20, 9);
  set.frames.push_back({0, {}, stand});
  RigidTransform pose = RigidTransform::planar(3.0, 1.0, 0.5);
  Frame second{1, {0.0, pose}, {}};
  for (std::size_t i = 0; i < 5; ++i) {
    Stem s = stand[i];
    const Eigen::Vector3d p = pose.inverse() * Eigen::Vector3d(s.x_m, s.y_m, *s.z_m);
    s.x_m = p.x();
    s.y_m = p.y();
    second.stems.push_back(s);
  }
  set.frames.push_back(second);
  PrepareSettings settings;
  settings.min_reconstructed = 10;
  EXPECT_EQ(prepare_frame_scene(set, 1, settings, {}).trees.size(), 20U);
  settings.preceding_frames = 0;
  EXPECT_EQ(prepare_frame_scene(set, 1, settings, {}).trees.size(), 5U);
}

}  // namespace
}  // namespace stemwise::treeloc
