// The steps that were made fast, against the same said plainly.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/near_origins.hpp"
#include "core/treeloc/triangle_index.hpp"
#include "core/treeloc/triangles.hpp"

namespace stemwise::treeloc {
namespace {

/// Trees at random, in order of x; some share a place or an x with others.
Scene random_scene(std::size_t trees, double radius_m, Random& random) {
  Scene scene;
  for (std::size_t i = 0; i < trees; ++i) {
    SceneTree tree;
    tree.position_m = {random.uniform(-radius_m, radius_m), random.uniform(-radius_m, radius_m), 0.0};
    tree.dbh_m = random.uniform(0.1, 0.6);
    scene.trees.push_back(tree);
    if (i % 7 == 3) scene.trees.back().position_m.x() = scene.trees[i - 1].position_m.x();
    if (i % 11 == 5) scene.trees.back().position_m = scene.trees[i - 2].position_m;
  }
  std::stable_sort(scene.trees.begin(), scene.trees.end(),
                   [](const SceneTree& a, const SceneTree& b) { return a.position_m.x() < b.position_m.x(); });
  return scene;
}

TEST(NearOrigins, AreThoseWithinTheRadiusAlsoAtTheEdgeAndFarApart) {
  Random random(1);
  const std::int32_t radius = 700;
  for (int trial = 0; trial < 2000; ++trial) {
    const double spread = trial % 2 == 0 ? 1200.0 : 32000.0;
    const auto any = [&] { return static_cast<std::int16_t>(random.uniform(-spread, spread)); };
    const TriangleOrigin at{any(), any()};
    TriangleOrigin origins[near_origins_lanes];
    for (auto& o : origins) o = {any(), any()};
    origins[trial % 8] = {static_cast<std::int16_t>(std::clamp(at.x_cm + radius, -32000, 32000)), at.y_cm};  // on the edge
    origins[(trial + 3) % 8] = {at.x_cm, static_cast<std::int16_t>(std::clamp(at.y_cm + radius + 1, -32000, 32000))};
    unsigned expected = 0;
    for (unsigned i = 0; i < near_origins_lanes; ++i) {
      if (std::hypot(double(origins[i].x_cm) - at.x_cm, double(origins[i].y_cm) - at.y_cm) <= radius) expected |= 1U << i;
    }
    ASSERT_EQ(near_origins_mask(origins, at, radius * radius), expected) << trial;
  }
  TriangleOrigin corner[near_origins_lanes];
  for (auto& o : corner) o = {32000, 32000};
  EXPECT_EQ(near_origins_mask(corner, {-32000, -32000}, radius * radius), 0U) << "the farthest two can be";
}

/// Every tree with each pair of its nearest ones (ties: the earlier tree), each triple once.
std::set<std::array<std::size_t, 3>> triples_of(const Scene& scene, std::size_t neighbours) {
  std::set<std::array<std::size_t, 3>> triples;
  const auto distance = [&](std::size_t a, std::size_t b) {
    const Eigen::Vector2f d =
        scene.trees[a].position_m.head<2>().cast<float>() - scene.trees[b].position_m.head<2>().cast<float>();
    return std::sqrt(d.x() * d.x() + d.y() * d.y());
  };
  for (std::size_t i = 0; i < scene.trees.size(); ++i) {
    std::vector<std::pair<float, std::size_t>> near;
    for (std::size_t j = 0; j < scene.trees.size(); ++j) {
      if (j != i) near.push_back({distance(i, j), j});
    }
    std::sort(near.begin(), near.end());
    near.resize(std::min(near.size(), neighbours));
    for (const auto& a : near) {
      for (const auto& b : near) {
        std::array<std::size_t, 3> triple{i, a.second, b.second};
        const float sides[3] = {distance(i, a.second), distance(i, b.second), distance(a.second, b.second)};
        std::sort(triple.begin(), triple.end());
        if (a.second < b.second && *std::min_element(sides, sides + 3) >= 0.5F && *std::max_element(sides, sides + 3) <= 30.0F)
          triples.insert(triple);
      }
    }
  }
  return triples;
}

TEST(TriangleMaker, MakesThePairsOfNeighboursOfScenesOfAnySize) {
  Random random(2);
  TriangleMaker maker({});
  for (const std::size_t trees : {0U, 1U, 2U, 3U, 12U, 13U, 30U, 63U, 64U, 65U, 128U, 200U, 255U}) {
    const Scene scene = random_scene(trees, 30.0, random);
    std::set<std::array<std::size_t, 3>> made;
    for (const Triangle& t : maker.make(scene)) {
      std::array<std::size_t, 3> triple{t.tree[0], t.tree[1], t.tree[2]};
      std::sort(triple.begin(), triple.end());
      EXPECT_TRUE(made.insert(triple).second) << trees << " trees: a triple was made twice";
    }
    EXPECT_EQ(made, triples_of(scene, 12)) << trees << " trees";
  }
}

TEST(TriangleMaker, OriginYawAndKeyFollowFromTheCorners) {
  Random random(3);
  const TriangleSettings settings;
  TriangleMaker maker(settings);
  const Scene scene = random_scene(80, 30.0, random);
  ASSERT_GT(maker.make(scene).size(), 1000U);
  for (const Triangle& t : maker.make(scene)) {
    Eigen::Vector2d corner[3];
    for (int v = 0; v < 3; ++v) corner[v] = scene.trees[t.tree[v]].position_m.head<2>();
    const Eigen::Vector2d longest = corner[1] - corner[0], middle = (corner[0] + corner[1] + corner[2]) / 3.0;
    const double yaw = std::atan2(longest.y(), longest.x());
    const double step = t.yaw - yaw * 128.0 / std::numbers::pi;
    EXPECT_LT(std::abs(std::remainder(step, 256.0)), 0.6);
    const Eigen::Vector2d origin = Eigen::Rotation2Dd(-yaw) * -middle;
    EXPECT_NEAR(t.origin.x_cm, origin.x() * 100.0, 0.6);
    EXPECT_NEAR(t.origin.y_cm, origin.y() * 100.0, 0.6);
    const auto steps = [&](int a, int b) {
      const Eigen::Vector2f d =
          scene.trees[t.tree[a]].position_m.head<2>().cast<float>() - scene.trees[t.tree[b]].position_m.head<2>().cast<float>();
      return static_cast<std::uint32_t>(std::sqrt(d.x() * d.x() + d.y() * d.y()) * (1.0F / 0.15F));
    };
    const double twice_area = longest.x() * (corner[2] - corner[0]).y() - longest.y() * (corner[2] - corner[0]).x();
    if (std::abs(twice_area) < 1e-3) continue;  // single precision may see a line from either side
    EXPECT_EQ(t.key, maker.keys().key(steps(1, 2), steps(0, 2), steps(0, 1), 0, twice_area > 0.0));
  }
}

struct Listed {
  std::uint32_t scene;
  int x_cm, y_cm, yaw, dbh_cm;
  bool operator==(const Listed&) const = default;
};

std::vector<Listed> listed(const TriangleIndex& index, std::uint32_t key) {
  std::vector<Listed> all;
  for (std::size_t segment = 0; segment < index.segment_count(); ++segment) {
    const auto [first, count] = index.range(segment, key);
    for (std::uint32_t i = first; i < first + count; ++i) {
      const Posting& p = index.postings(segment)[i];
      const TriangleOrigin& origin = index.origins(segment)[i];
      all.push_back({p.scene, origin.x_cm, origin.y_cm, p.yaw, p.dbh_cm[2]});
    }
  }
  return all;
}

TEST(TriangleIndex, ListsEveryTriangleUnderItsKeyInOrderOfSceneAtAnyThreadCount) {
  Random random(5);
  const TriangleSettings settings;
  std::vector<Scene> scenes;
  for (int s = 0; s < 150; ++s) scenes.push_back(random_scene(20, 25.0, random));
  TriangleIndex one(settings), three(settings), in_parts(settings);
  one.add(scenes, 1);
  three.add(scenes, 3);
  in_parts.add(std::span(scenes).first(70), 2);
  in_parts.add(std::span(scenes).subspan(70), 2);
  std::map<std::uint32_t, std::vector<Listed>> expected;
  TriangleMaker maker(settings);
  std::size_t triangles = 0;
  for (std::uint32_t s = 0; s < scenes.size(); ++s) {
    for (const Triangle& t : maker.make(scenes[s])) {
      expected[t.key].push_back({s, t.origin.x_cm, t.origin.y_cm, t.yaw, t.dbh_cm[2]});
      ++triangles;
    }
  }
  for (const TriangleIndex* index : {&one, &three, &in_parts}) {
    EXPECT_EQ(index->triangle_count(), triangles);
    EXPECT_EQ(index->scene_count(), scenes.size());
    for (const auto& [key, triangles_of_key] : expected) ASSERT_EQ(listed(*index, key), triangles_of_key) << key;
  }
  EXPECT_TRUE(listed(one, maker.keys().count() - 1).empty()) << "the last key: a triangle of 30 m sides, which no scene has";
}

/// For every query tree the nearest tree that fits; of those that want the same one the nearest.
std::set<std::pair<int, int>> pairs_of(const PlanarTrees& query, const PlanarTrees& candidate, float radius) {
  std::vector<std::pair<float, int>> wanted(candidate.size(), {radius * radius, -1});
  for (std::size_t i = 0; i < query.size(); ++i) {
    float nearest_sq = radius * radius;
    std::size_t nearest = candidate.size();
    for (std::size_t j = 0; j < candidate.size(); ++j) {
      const float dx = query.x_m[i] - candidate.x_m[j], dy = query.y_m[i] - candidate.y_m[j];
      if (dx * dx + dy * dy < nearest_sq && std::abs(query.dbh_m[i] - candidate.dbh_m[j]) < 0.2F)
        nearest_sq = dx * dx + dy * dy, nearest = j;
    }
    if (nearest < candidate.size() && nearest_sq < wanted[nearest].first) wanted[nearest] = {nearest_sq, static_cast<int>(i)};
  }
  std::set<std::pair<int, int>> pairs;
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    if (wanted[j].second >= 0) pairs.insert({wanted[j].second, static_cast<int>(j)});
  }
  return pairs;
}

TEST(TreeMatcher, PairsWhatComparingEveryTreeWithEveryOtherPairs) {
  Random random(4);
  TreeMatcher matcher({});
  for (int trial = 0; trial < 60; ++trial) {
    PlanarTreeStore store;
    const double extent_m = trial % 3 == 0 ? 0.5 : 20.0;  // also trees that all lie within one strip
    store.add(random_scene(static_cast<std::size_t>(trial), 20.0, random));
    store.add(random_scene(static_cast<std::size_t>(60 - trial), extent_m, random));
    for (const float radius : {0.4F, 1.0F, 6.0F}) {
      matcher.pair(store.trees(0), store.trees(1), {}, radius);
      std::set<std::pair<int, int>> made;
      for (const TreePair& p : matcher.pairs()) made.insert({p.query, p.candidate});
      EXPECT_EQ(made, pairs_of(store.trees(0), store.trees(1), radius)) << trial << " " << radius;
    }
  }
}

}  // namespace
}  // namespace stemwise::treeloc
