#include "core/underlay/arrange_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/base/random.hpp"

namespace stemwise {
namespace {

/// A slope of 0.2 with stems of 10 m height every 5 m.
std::vector<RawPoint> slope_with_stems() {
  std::vector<RawPoint> points;
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    RawPoint p;
    p.position = {random.uniform(0.0, 40.0), random.uniform(0.0, 30.0), 0.0};
    p.position.z() = 0.2 * p.position.x() + random.normal(0.0, 0.02);
    p.intensity = static_cast<std::uint16_t>(100 + i % 1000);
    points.push_back(p);
  }
  for (double x = 2.5; x < 40.0; x += 5.0)
    for (double y = 2.5; y < 30.0; y += 5.0)
      for (int i = 0; i < 100; ++i) {
        RawPoint p;
        p.position = {x, y, 0.2 * x + 0.1 * i};
        points.push_back(p);
      }
  return points;
}

TEST(CloudThinner, KeepsOnePointPerCubeTheFirstOne) {
  CloudThinner thinner(1000, 1.0);
  RawPoint p;
  for (const double x : {0.1, 0.9, 1.2, -0.1}) {
    p.position.x() = x;
    thinner.add(p);
  }
  ASSERT_EQ(thinner.points().size(), 3u);  // cubes begin at the first point: 0.9 is in its cube
  CloudThinner again(1000, 1.0);
  for (const double x : {0.1, 0.9, 1.05, 1.2}) {
    p.position.x() = x;
    again.add(p);
  }
  ASSERT_EQ(again.points().size(), 2u);
  EXPECT_EQ(again.points()[0].position.x(), 0.1);
  EXPECT_EQ(again.points()[1].position.x(), 1.2);
}

TEST(CloudThinner, GrowsItsCubesInPlaceOfItsMemory) {
  CloudThinner thinner(1000, 0.01);
  Random random(3);
  for (int i = 0; i < 50'000; ++i) {
    RawPoint p;
    p.position = {random.uniform(0.0, 10.0), random.uniform(0.0, 10.0), random.uniform(0.0, 3.0)};
    thinner.add(p);
    ASSERT_LE(thinner.points().size(), 1000u);
  }
  EXPECT_GT(thinner.points().size(), 300u);
  EXPECT_GT(thinner.spacing_m(), 0.3);
}

TEST(CloudThinner, DropsWhatIsNoPlace) {
  CloudThinner thinner(10, 1.0);
  RawPoint p;
  p.position.z() = std::numeric_limits<double>::quiet_NaN();
  thinner.add(p);
  p.position.z() = std::numeric_limits<double>::infinity();
  thinner.add(p);
  EXPECT_TRUE(thinner.points().empty());
}

TEST(ArrangeCloud, FindsTheGroundUnderStemsOnASlope) {
  const CloudUnderlay cloud = arrange_cloud(slope_with_stems(), 0.05);
  double worst_m = 0.0, highest_m = 0.0;
  for (const CloudPoint& p : cloud.points) {
    const Eigen::Vector3d at = cloud.origin_in_reference_m + Eigen::Vector3d(p.x_m, p.y_m, p.z_m);
    const double truth_m = at.z() - 0.2 * at.x();
    worst_m = std::max(worst_m, std::abs(truth_m - p.above_ground_m));
    highest_m = std::max(highest_m, static_cast<double>(p.above_ground_m));
  }
  EXPECT_LT(worst_m, 0.45);  // low end of a square on a slope: 0.2 * 2 m at most
  EXPECT_NEAR(highest_m, 9.9, 0.4);
}

TEST(ArrangeCloud, AnyFirstPartOfATileIsAnEvenChoice) {
  const CloudUnderlay cloud = arrange_cloud(slope_with_stems(), 0.05);
  ASSERT_GT(cloud.tiles.size(), 20u);
  std::size_t all = 0;
  for (const CloudTile& tile : cloud.tiles) {
    EXPECT_EQ(tile.first, all);
    all += tile.count;
    if (tile.count < 200) continue;
    double mean_part = 0.0, mean_all = 0.0;
    for (std::size_t i = 0; i < tile.count; ++i) {
      const double x = cloud.points[tile.first + i].x_m;
      mean_all += x / static_cast<double>(tile.count);
      if (i < tile.count / 4) mean_part += x / static_cast<double>(tile.count / 4);
    }
    EXPECT_NEAR(mean_part, mean_all, 0.25 * cloud.tile_m);
  }
  EXPECT_EQ(all, cloud.points.size());
}

TEST(ArrangeCloud, ClassifiedGroundGoesBeforeTheLowestPoints) {
  std::vector<RawPoint> points = slope_with_stems();
  for (std::size_t i = 0; i < 20'000; ++i) points[i].is_ground = i % 2 == 0;
  RawPoint pit;  // multipath, far below
  pit.position = {20.0, 15.0, -30.0};
  for (int i = 0; i < 60; ++i) points.push_back(pit);
  const CloudUnderlay cloud = arrange_cloud(points, 0.05);
  for (const CloudPoint& p : cloud.points) {
    const Eigen::Vector3d at = cloud.origin_in_reference_m + Eigen::Vector3d(p.x_m, p.y_m, p.z_m);
    if (at.z() > -10.0) {
      EXPECT_NEAR(at.z() - 0.2 * at.x(), p.above_ground_m, 0.45);
    }
  }
}

TEST(ArrangeCloud, OnePointAndNoneAreClouds) {
  EXPECT_TRUE(arrange_cloud({}, 0.1).points.empty());
  const CloudUnderlay one = arrange_cloud({RawPoint{.position = {5e5, 5.4e6, 300.0}}}, 0.1);
  ASSERT_EQ(one.points.size(), 1u);
  EXPECT_FALSE(one.has_colour);
  EXPECT_FALSE(one.has_intensity);
  EXPECT_EQ(one.points[0].above_ground_m, 0.0F);
}

}  // namespace
}  // namespace stemwise
