#include "core/geometry/drawn_polygon.hpp"

#include <gtest/gtest.h>

namespace stemwise {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

TEST(DrawnPolygon, TakesCornersInAnyDirection) {
  const auto forth = drawn_polygon(Corners{{0, 0}, {10, 0}, {10, 5}, {0, 5}}), back = drawn_polygon(Corners{{0, 5}, {10, 5}, {10, 0}, {0, 0}});
  ASSERT_TRUE(forth && back);
  EXPECT_EQ(forth->corners_m, back->corners_m);
  EXPECT_NEAR(area_sq_m(*back), 50.0, 1e-9);
}

TEST(DrawnPolygon, RefusesTooFewCornersNoAreaAndSidesThatCross) {
  EXPECT_FALSE(drawn_polygon(Corners{{0, 0}, {10, 0}}));
  EXPECT_FALSE(drawn_polygon(Corners{{0, 0}, {10, 0}, {20, 0}}));
  const auto bow = drawn_polygon(Corners{{0, 0}, {10, 10}, {10, 0}, {0, 9}});
  ASSERT_FALSE(bow);
  EXPECT_NE(bow.issues.front().text.find("cross"), std::string::npos);
}

TEST(DrawnPolygon, LosesNothingFarFromTheOrigin) {
  const Eigen::Vector2d far(512000.0, 5402000.0);
  const auto polygon = drawn_polygon(Corners{far, far + Eigen::Vector2d(10, 0), far + Eigen::Vector2d(10, 10), far + Eigen::Vector2d(0, 10)});
  ASSERT_TRUE(polygon);
}

}  // namespace
}  // namespace stemwise
