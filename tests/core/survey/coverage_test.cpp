#include "core/survey/coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/random.hpp"
#include "core/survey/place_coverage.hpp"

namespace stemwise {
namespace {

Stem stem_at(double x_m, double y_m) {
  Stem s;
  s.x_m = x_m;
  s.y_m = y_m;
  return s;
}

std::vector<Stem> scattered(int n, double width_m, double height_m, std::uint64_t seed, const Eigen::Vector2d& origin = {0, 0}) {
  Random random(seed);
  std::vector<Stem> stems;
  for (int i = 0; i < n; ++i) stems.push_back(stem_at(origin.x() + random.uniform(0, width_m), origin.y() + random.uniform(0, height_m)));
  return stems;
}

/// No two edges cross and no corner comes twice.
bool is_simple(const Polygon& p) {
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
  const auto& c = p.corners_m;
  const std::size_t n = c.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;
      const Eigen::Vector2d &a = c[i], &b = c[i + 1], &u = c[j], &v = c[(j + 1) % n];
      if (cross(b - a, u - a) * cross(b - a, v - a) < 0 && cross(v - u, a - u) * cross(v - u, b - u) < 0) return false;
      if (a == u || a == v) return false;
    }
  return true;
}

FrameSet walk_along(const std::vector<Eigen::Vector2d>& path, double range_m) {
  FrameSet frames;
  for (const auto& at : path) {
    Frame frame;
    frame.number = static_cast<std::int64_t>(frames.frames.size());
    frame.pose.survey_from_frame.translation_m = {at.x(), at.y(), 1.5};
    for (int i = 0; i < 20; ++i) frame.stems.push_back(stem_at(range_m * std::cos(i), range_m * std::sin(i)));
    frames.frames.push_back(frame);
  }
  return frames;
}

TEST(Coverage, OfALeaningFrameLiesWhereItsStemsLie) {
  Inventory inventory;
  inventory.stems = scattered(400, 60, 60, 8);
  const RigidTransform leaning{rotation_from({0.15, -0.1, 0.7}), {100, 50, -20}};
  for (Stem& stem : inventory.stems) stem.z_m = 40.0 - 0.15 * stem.y_m;  // ground far below the origin
  const Polygon placed = place_coverage(coverage_from_stems(inventory.stems).in_inventory, inventory, leaning);
  int inside = 0;
  for (const Stem& stem : inventory.stems)
    inside += contains(placed, (leaning * Eigen::Vector3d(stem.x_m, stem.y_m, *stem.z_m)).head<2>()) ? 1 : 0;
  EXPECT_GE(inside, 396);
}

TEST(Coverage, OfARectangleOfStemsIsTheRectangle) {
  const std::vector<Stem> stems = scattered(1500, 120, 80, 1);
  const Coverage coverage = coverage_from_stems(stems);
  EXPECT_NEAR(area_sq_m(coverage.in_inventory), 120.0 * 80.0, 200.0);
  EXPECT_TRUE(is_simple(coverage.in_inventory));
  EXPECT_EQ(coverage.source, CoverageSource::stems);
  const auto inside = std::count_if(stems.begin(), stems.end(), [&](const Stem& s) { return contains(coverage.in_inventory, {s.x_m, s.y_m}); });
  EXPECT_GE(inside, 1495);
}

TEST(Coverage, OfAnLShapeLeavesTheNotchOut) {
  std::vector<Stem> stems = scattered(800, 100, 40, 2);
  const std::vector<Stem> upright = scattered(800, 40, 100, 3);
  stems.insert(stems.end(), upright.begin(), upright.end());
  const Polygon polygon = coverage_from_stems(stems).in_inventory;
  EXPECT_FALSE(contains(polygon, {80, 80}));
  EXPECT_NEAR(area_sq_m(polygon), 6400.0, 900.0);
}

TEST(Coverage, IsTheSameAtUtmScale) {
  const Eigen::Vector2d utm(512345.25, 5412345.75);
  const double here = area_sq_m(coverage_from_stems(scattered(300, 50, 50, 4)).in_inventory);
  const Coverage there = coverage_from_stems(scattered(300, 50, 50, 4, utm));
  EXPECT_NEAR(area_sq_m(there.in_inventory), here, 25.0);
  EXPECT_TRUE(contains(there.in_inventory, utm + Eigen::Vector2d(25, 25)));
}

TEST(Coverage, OfScatteredStemsHasTheAreaOfTheirPlotAtAnyNumber) {
  for (const int n : {60, 150, 400, 1500}) {
    const double side_m = 5.0 * std::sqrt(n), plot_sq_m = side_m * side_m;
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const double area = area_sq_m(coverage_from_stems(scattered(n, side_m, side_m, seed)).in_inventory);
      EXPECT_NEAR(area, plot_sq_m, 0.2 * plot_sq_m) << n << " stems, seed " << seed;
      sum += area / 12.0;
    }
    EXPECT_NEAR(sum, plot_sq_m, 0.04 * plot_sq_m) << n << " stems";
  }
}

/// Two surveys of one plot in the frame of the reference; the second without some of the first one's stems.
std::vector<Coverage> coverages_of(const std::vector<Stem>& first, const std::vector<Stem>& second) {
  const Inventory a{InventoryId{1}, "a", {}, first, {}, nullptr}, b{InventoryId{2}, "b", {}, second, {}, nullptr};
  SurveyAlignment alignment;
  for (const Inventory* inventory : {&a, &b}) {
    InventoryAlignment placed;
    placed.inventory = inventory->id;
    placed.status = inventory == &a ? AlignmentStatus::reference : AlignmentStatus::aligned;
    alignment.inventories.push_back(placed);
  }
  return estimate_coverages(std::vector<const Inventory*>{&a, &b}, alignment);
}

TEST(Coverage, ATreeOfTheBorderThatIsGoneStillStandsInside) {
  const std::vector<Stem> first = scattered(500, 100, 100, 9);
  std::vector<Stem> second, gone;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double to_border_m = std::min({first[i].x_m, first[i].y_m, 100.0 - first[i].x_m, 100.0 - first[i].y_m});
    (to_border_m < 3.0 && i % 4 == 0 ? gone : second).push_back(first[i]);
  }
  const auto well_inside = [&](const Coverage& coverage) {
    return std::count_if(gone.begin(), gone.end(), [&](const Stem& s) {
      return distance_to_edge_m(coverage.in_inventory, {s.x_m, s.y_m}) > 1.0 && contains(coverage.in_inventory, {s.x_m, s.y_m});
    });
  };
  const auto alone = well_inside(coverage_from_stems(second)), together = well_inside(coverages_of(first, second)[1]);
  EXPECT_GT(together, alone);
  EXPECT_GE(together, static_cast<std::ptrdiff_t>(gone.size()) - 1);
}

TEST(Coverage, AStripThatWasNotSurveyedStaysOutside) {
  const std::vector<Stem> first = scattered(600, 100, 100, 10);
  std::vector<Stem> second;
  for (const Stem& s : first)
    if (s.x_m > 8.0) second.push_back(s);
  const Coverage alone = coverage_from_stems(second), together = coverages_of(first, second)[1];
  EXPECT_NEAR(area_sq_m(together.in_inventory), area_sq_m(alone.in_inventory), 60.0);
  int claimed = 0;
  for (const Stem& s : first) claimed += s.x_m < 4.0 && contains(together.in_inventory, {s.x_m, s.y_m}) ? 1 : 0;
  EXPECT_EQ(claimed, 0);
}

TEST(Coverage, OfFewStemsIsSmallAndNotEmpty) {
  EXPECT_TRUE(coverage_from_stems({}).in_inventory.empty());
  const std::vector<Stem> one{stem_at(3, 4)};
  EXPECT_NEAR(area_sq_m(coverage_from_stems(one).in_inventory), 25 * std::numbers::pi, 8.0);
  const std::vector<Stem> line{stem_at(0, 0), stem_at(5, 0), stem_at(10, 0), stem_at(15, 0)};
  for (const Stem& s : line) EXPECT_TRUE(contains(coverage_from_stems(line).in_inventory, {s.x_m, s.y_m}));
}

TEST(Coverage, OfAStraightRouteIsABandAroundIt) {
  std::vector<Eigen::Vector2d> path;
  for (int i = 0; i <= 100; ++i) path.emplace_back(2.0 * i, 0.0);
  const Coverage coverage = coverage_from_frames(walk_along(path, 20.0));
  EXPECT_EQ(coverage.source, CoverageSource::frames);
  EXPECT_NEAR(area_sq_m(coverage.in_inventory), 200 * 40 + 400 * std::numbers::pi, 300.0);
  EXPECT_TRUE(is_simple(coverage.in_inventory));
}

TEST(Coverage, OfALoopDoesNotClaimTheUnseenMiddle) {
  std::vector<Eigen::Vector2d> path;
  for (int i = 0; i <= 300; ++i) path.emplace_back(100 * std::cos(i / 300.0 * 6.2832), 100 * std::sin(i / 300.0 * 6.2832));
  const Polygon polygon = coverage_from_frames(walk_along(path, 20.0)).in_inventory;
  EXPECT_FALSE(contains(polygon, {0, 0}));
  EXPECT_FALSE(contains(polygon, {60, 20}));
  EXPECT_TRUE(contains(polygon, {0, 100}));
  EXPECT_TRUE(contains(polygon, {-95, 10}));
  EXPECT_NEAR(area_sq_m(polygon), std::numbers::pi * (120 * 120 - 80 * 80), 500.0);
  EXPECT_TRUE(is_simple(polygon));
}

TEST(Coverage, OfAnInventoryPrefersItsFrames) {
  Inventory inventory;
  inventory.stems = scattered(100, 30, 30, 5);
  EXPECT_EQ(estimate_coverage(inventory).source, CoverageSource::stems);
  inventory.frames = std::make_shared<FrameSet>(walk_along({{0, 0}, {2, 0}}, 15.0));
  EXPECT_EQ(estimate_coverage(inventory).source, CoverageSource::frames);
}

}  // namespace
}  // namespace stemwise
