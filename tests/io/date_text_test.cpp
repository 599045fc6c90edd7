#include "io/date_text.hpp"

#include <gtest/gtest.h>

namespace stemwise {
namespace {

const Date may_13 = date_from_civil(2021, 5, 13);

TEST(DateText, ReadsWhatFieldCrewsAndSpreadsheetsWrite) {
  for (const char* text : {"13.5.21", "13.05.2021", "13-May-21", "13-May-2021", "May 13, 2021", "May 13th, 2021", "13. Mai 2021", "13 mai 2021", "13 de mayo de 2021", "13 maggio 2021", "2021 May 13",
                           "13/5/2021", "5/13/2021", "5/13/21", "2021-05-13T10:00:00", "13.5.21 10:00", "13 Mai 2021 10:00"})
    EXPECT_EQ(date_from_text(text), may_13) << text;
  EXPECT_EQ(date_from_text("März 2021"), date_from_civil(2021, 3, 15));
  EXPECT_EQ(date_from_text("1er août 2021"), date_from_civil(2021, 8, 1));
  EXPECT_EQ(date_from_text("2021.0"), date_from_civil(2021, 7, 1));
  EXPECT_EQ(date_from_text("1.2.75"), date_from_civil(1975, 2, 1));
}

TEST(DateText, OrderDecidesSlashesOnlyWhereTheNumbersDoNot) {
  EXPECT_FALSE(date_from_text("5/6/2021"));
  EXPECT_EQ(date_from_text("5/6/2021", DayOrder::day_first), date_from_civil(2021, 6, 5));
  EXPECT_EQ(date_from_text("5/6/2021", DayOrder::month_first), date_from_civil(2021, 5, 6));
  EXPECT_EQ(date_from_text("13/5/2021", DayOrder::month_first), may_13);
  EXPECT_EQ(order_told_by("13/5/2021"), DayOrder::day_first);
  EXPECT_EQ(order_told_by("5/13/21"), DayOrder::month_first);
  EXPECT_EQ(order_told_by("5/6/2021"), DayOrder::unknown);
}

TEST(DateText, WhatIsNoDateIsNone) {
  for (const char* text : {"soon", "", "31/31/2021", "32. Mai 2021", "May", "13 2021", "44329", "1.2", "5-6-21"}) EXPECT_FALSE(date_from_text(text)) << text;
}

TEST(DateText, SpreadsheetDayCountsAreDaysSince1900) {
  EXPECT_EQ(date_from_serial("44329"), may_13);
  EXPECT_EQ(date_from_serial("44329.75"), may_13);
  EXPECT_FALSE(date_from_serial("17826"));  // ForestGEO counts from 1960
  EXPECT_FALSE(date_from_serial("soon"));
}

}  // namespace
}  // namespace stemwise
