#include "ui/text/format.hpp"

#include <gtest/gtest.h>

namespace stemwise::ui {
namespace {

TEST(Format, NegativeNumbersHaveATrueMinusSignAndZeroHasNone) {
  EXPECT_EQ(fixed(-4.2, 1), "−4.2");
  EXPECT_EQ(fixed(-0.04, 1), "0.0");
  EXPECT_EQ(change_text(0.012), "+1.2");
  EXPECT_EQ(change_text(-0.042), "−4.2");
  EXPECT_EQ(change_text(std::nullopt), dash);
}

TEST(Format, CountsAndCoordinatesAreGrouped) {
  EXPECT_EQ(count_text(4120), "4,120");
  EXPECT_EQ(plural(1, "stem", "stems"), "1 stem");
  EXPECT_EQ(grouped(5402096.04, 1), "5\u2009402\u2009096.0");
  EXPECT_EQ(grouped(-512.5, 1), "−512.5");
}

TEST(Format, LengthsCarryTheirUnits) {
  EXPECT_EQ(dbh_text(0.314), "31.4");
  EXPECT_EQ(distance_text(0.312), "0.31 m");
  EXPECT_EQ(residual_text(0.071), "7.1 cm");
}

TEST(Format, DatesAndTimesReadLikeSentences) {
  EXPECT_EQ(date_text(date_from_civil(2013, 4, 1)), "1 Apr 2013");
  EXPECT_EQ(duration_text(4.2), "4 s");
  EXPECT_EQ(duration_text(130.0), "2 min 10 s");
  EXPECT_EQ(ago_text(12.9), "12 s ago");
}

}  // namespace
}  // namespace stemwise::ui
