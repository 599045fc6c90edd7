#include "core/geometry/polygon.hpp"

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/geometry/near_edge.hpp"

namespace stemwise {
namespace {

Polygon square(double x_m, double y_m, double side_m) {
  return {{{x_m, y_m}, {x_m + side_m, y_m}, {x_m + side_m, y_m + side_m}, {x_m, y_m + side_m}}};
}

TEST(Polygon, AreaOfASquareAtUtmScaleIsExactToASquareMillimetre) {
  EXPECT_NEAR(area_sq_m(square(512345.678, 5412345.678, 40.0)), 1600.0, 1e-6);
}

TEST(Polygon, AreaDoesNotDependOnTheSenseOfTurning) {
  Polygon p = square(0, 0, 3);
  std::reverse(p.corners_m.begin(), p.corners_m.end());
  EXPECT_DOUBLE_EQ(area_sq_m(p), 9.0);
}

TEST(Polygon, ContainsItsInsideItsCornersAndItsEdgesAndNothingElse) {
  const Polygon p = square(10, 20, 4);
  EXPECT_TRUE(contains(p, {12, 22}));
  EXPECT_TRUE(contains(p, {10, 20}));
  EXPECT_TRUE(contains(p, {14, 22}));
  EXPECT_FALSE(contains(p, {14.001, 22}));
  EXPECT_FALSE(contains(p, {9, 20}));
  EXPECT_FALSE(contains(Polygon{}, {0, 0}));
}

TEST(Polygon, ContainsRespectsANotch) {
  const Polygon p{{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}};
  EXPECT_FALSE(contains(p, {2, 2}));
  EXPECT_TRUE(contains(p, {2, 0.5}));
  EXPECT_TRUE(contains(p, {0.2, 3}));
}

TEST(Polygon, DistanceToTheEdgeIsThatToTheNearestSideInsideAndOutside) {
  const Polygon p = square(0, 0, 10);
  EXPECT_DOUBLE_EQ(distance_to_edge_m(p, {5, 2}), 2.0);
  EXPECT_DOUBLE_EQ(distance_to_edge_m(p, {5, -3}), 3.0);
  EXPECT_DOUBLE_EQ(distance_to_edge_m(p, {13, 14}), 5.0);
}

TEST(Polygon, IsNearItsEdgeWhereTheDistanceToTheEdgeIsBelowTheLimit) {
  Random random(5);
  Polygon star;
  for (int i = 0; i < 90; ++i) {
    const double radius_m = random.uniform(20, 50), angle = 2.0 * 3.14159265358979 * i / 90.0;
    star.corners_m.emplace_back(radius_m * std::cos(angle), radius_m * std::sin(angle));
  }
  int near = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d p(random.uniform(-60, 60), random.uniform(-60, 60));
    const bool said = is_near_edge(star, p, 2.5);
    EXPECT_EQ(said, distance_to_edge_m(star, p) < 2.5);
    near += said ? 1 : 0;
  }
  EXPECT_GT(near, 100);
  EXPECT_LT(near, 1900);
}

TEST(Polygon, ConvexHullHoldsEveryPointAndTurnsLeftEverywhere) {
  Random random(3);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(random.uniform(0, 100), random.uniform(0, 60));
  const Polygon hull = convex_hull(points);
  ASSERT_GE(hull.corners_m.size(), 3u);
  for (const auto& p : points) EXPECT_TRUE(contains(hull, p));
  for (std::size_t i = 0; i < hull.corners_m.size(); ++i) {
    const Eigen::Vector2d& a = hull.corners_m[i];
    const Eigen::Vector2d& b = hull.corners_m[(i + 1) % hull.corners_m.size()];
    const Eigen::Vector2d& c = hull.corners_m[(i + 2) % hull.corners_m.size()];
    EXPECT_GT((b - a).x() * (c - b).y() - (b - a).y() * (c - b).x(), 0.0);
  }
}

TEST(Polygon, ConvexHullOfPointsOnALineOrOfTwoPointsIsEmpty) {
  const std::vector<Eigen::Vector2d> line{{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  EXPECT_TRUE(convex_hull(line).empty());
  EXPECT_TRUE(convex_hull(std::vector<Eigen::Vector2d>{{0, 0}, {0, 0}, {1, 0}}).empty());
}

}  // namespace
}  // namespace stemwise
