#include "core/geometry/raster_mask.hpp"

#include <gtest/gtest.h>

namespace stemwise {
namespace {

/// Squares of one metre from the lower left corners given, in a frame of 40 m.
RasterMask cells(const std::vector<Eigen::Vector2d>& lower_left) {
  const std::vector<Eigen::Vector2d> frame{{0, 0}, {40, 40}};
  RasterMask mask(frame, 2.0, 1.0);
  for (const auto& p : lower_left) mask.set(p + Eigen::Vector2d(0.5, 0.5));
  return mask;
}

std::vector<Eigen::Vector2d> block(int x0, int y0, int side) {
  std::vector<Eigen::Vector2d> result;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y) result.emplace_back(x0 + x, y0 + y);
  return result;
}

TEST(RasterMask, KeepsTheLargestOfItsParts) {
  auto places = block(2, 2, 3);
  const auto large = block(10, 20, 6);
  places.insert(places.end(), large.begin(), large.end());
  const RasterMask mask = cells(places);
  EXPECT_EQ(mask.part_count(), 2u);
  const RasterMask part = mask.largest_part();
  EXPECT_EQ(part.count(), 36u);
  EXPECT_EQ(part.part_count(), 1u);
  EXPECT_TRUE(part.at({12.5, 22.5}));
  EXPECT_FALSE(part.at({3.5, 3.5}));
}

TEST(RasterMask, PartsThatMeetAtACornerOnlyAreTwo) { EXPECT_EQ(cells({{5, 5}, {6, 6}}).part_count(), 2u); }

TEST(RasterMask, SmallHolesAreFilledAndLargeOnesAndTheOutsideAreNot) {
  auto places = block(5, 5, 20);
  std::erase_if(places, [](const Eigen::Vector2d& p) {
    const bool small = p.x() == 7 && p.y() == 7;
    const bool large = p.x() >= 12 && p.x() < 16 && p.y() >= 12 && p.y() < 16;
    return small || large;
  });
  const RasterMask filled = cells(places).without_holes(5.0);
  EXPECT_TRUE(filled.at({7.5, 7.5}));
  EXPECT_FALSE(filled.at({13.5, 13.5}));
  EXPECT_FALSE(filled.at({2.5, 2.5}));
  EXPECT_EQ(filled.count(), 384u);
}

TEST(RasterMask, NothingHasNoParts) {
  EXPECT_EQ(cells({}).part_count(), 0u);
  EXPECT_EQ(cells({}).largest_part().count(), 0u);
}

}  // namespace
}  // namespace stemwise
