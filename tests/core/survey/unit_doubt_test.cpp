#include "core/survey/unit_doubt.hpp"

#include <gtest/gtest.h>

#include "tests/core/project/small_project.hpp"

namespace stemwise {
namespace {

TEST(UnitDoubts, AForestThatGrowsRaisesNone) { EXPECT_TRUE(unit_doubts(test::aligned_project().state()).empty()); }

TEST(UnitDoubts, DiametersATenthOfWhatTheyWereAreNamedWithTheirSurveys) {
  ProjectState state = test::aligned_project().state();
  Inventory tenth = *state.inventories[2];
  for (Stem& stem : tenth.stems) *stem.dbh_m /= 10.0;
  state.inventories[2] = std::make_shared<const Inventory>(tenth);
  const std::vector<std::string> doubts = unit_doubts(state);
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_NE(doubts[0].find("2023"), std::string::npos) << doubts[0];
  EXPECT_NE(doubts[0].find("0.10 times those of 2018"), std::string::npos) << doubts[0];
}

}  // namespace
}  // namespace stemwise
