#include "core/survey/outline_coverage.hpp"

#include <gtest/gtest.h>

#include "core/base/random.hpp"

namespace stemwise {
namespace {

std::vector<Eigen::Vector2d> stand(double width_m, double height_m, int stems, std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < stems; ++i) points.emplace_back(random.uniform(0.0, width_m), random.uniform(0.0, height_m));
  return points;
}

TEST(OutlineCoverage, OfASquareStandIsTheSquareWithinAFewPercent) {
  const Polygon outline = outline_of(stand(100.0, 100.0, 600));
  EXPECT_NEAR(area_sq_m(outline), 10000.0, 600.0);
}

TEST(OutlineCoverage, LeavesOutTheBayOfAnLShapedStand) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector2d& p : stand(200.0, 200.0, 2000)) {
    if (p.x() < 80.0 || p.y() < 80.0) points.push_back(p);
  }
  const Polygon outline = outline_of(points);
  EXPECT_NEAR(area_sq_m(outline), 25600.0, 2000.0);
  EXPECT_FALSE(contains(outline, {150.0, 150.0}));
  EXPECT_TRUE(contains(outline, {40.0, 150.0}));
}

TEST(OutlineCoverage, HoldsNearlyEveryStemAndTurnsAndShiftsWithThem) {
  const auto points = stand(120.0, 90.0, 700);
  const Polygon outline = outline_of(points);
  int inside = 0;
  for (const auto& p : points) inside += contains(outline, p) ? 1 : 0;
  EXPECT_GE(inside, 680);
  std::vector<Eigen::Vector2d> shifted;
  for (const auto& p : points) shifted.push_back(p + Eigen::Vector2d(500000.0, 5400000.0));
  EXPECT_NEAR(area_sq_m(outline_of(shifted)), area_sq_m(outline), 0.02 * area_sq_m(outline));
}

TEST(OutlineCoverage, OfSeparatePlotsIsTheirHull) {
  std::vector<Eigen::Vector2d> points = stand(30.0, 30.0, 60);
  for (const auto& p : stand(30.0, 30.0, 60, 2)) points.push_back(p + Eigen::Vector2d(300.0, 0.0));
  EXPECT_GT(area_sq_m(outline_of(points)), 5000.0);
}

TEST(OutlineCoverage, OfTwoStemsIsNone) { EXPECT_TRUE(outline_of(std::vector<Eigen::Vector2d>{{0, 0}, {1, 1}}).empty()); }

}  // namespace
}  // namespace stemwise
