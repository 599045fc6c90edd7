#include "render/cut_grid.hpp"

#include <gtest/gtest.h>

namespace stemwise::render {
namespace {

TEST(CutGrid, WholeCellsStayWholeAndCellsOutsideAreGone) {
  const std::vector<float> in(6, 1.0F), out(6, -1.0F);
  const auto pieces = cut_cells(3, 2, in);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].size(), 4U);
  for (const CutCorner& corner : pieces[0]) EXPECT_TRUE(corner.is_node());
  EXPECT_TRUE(cut_cells(3, 2, out).empty());
}

TEST(CutGrid, TheEdgeRunsWhereTheFieldIsZero) {
  // The right side lies outside: three quarters of the way are in.
  const auto pieces = cut_cells(2, 2, std::vector<float>{3.0F, -1.0F, 3.0F, -1.0F});
  ASSERT_EQ(pieces.size(), 1U);
  ASSERT_EQ(pieces[0].size(), 4U);
  for (const CutCorner& corner : pieces[0]) {
    if (corner.is_node()) continue;
    const double from_inside = corner.from % 2 == 0 ? corner.share : 1.0 - corner.share;
    EXPECT_NEAR(from_inside, 0.75, 1e-12);
  }
}

TEST(CutGrid, AGridLineKeepsItsPartInside) {
  EXPECT_EQ(inner_shares(1.0F, 1.0F), (std::array{0.0, 1.0}));
  EXPECT_EQ(inner_shares(-1.0F, -1.0F), (std::array{0.0, 0.0}));
  EXPECT_EQ(inner_shares(1.0F, -1.0F), (std::array{0.0, 0.5}));
  EXPECT_EQ(inner_shares(-1.0F, 3.0F), (std::array{0.25, 1.0}));
}

}  // namespace
}  // namespace stemwise::render
