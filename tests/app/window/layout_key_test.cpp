#include "app/window/layout_key.hpp"

#include <gtest/gtest.h>

namespace stemwise {
namespace {

TEST(LayoutKey, LettersAreThoseThatThePersonSees) {
  EXPECT_EQ(layout_key('Y', "z"), 'Z');  // German: Undo is where Z is written
  EXPECT_EQ(layout_key('Z', "y"), 'Y');
  EXPECT_EQ(layout_key('Q', "a"), 'A');  // French
  EXPECT_EQ(layout_key('A', "a"), 'A');
}

TEST(LayoutKey, DigitsStayWhereTheyAreAlsoWhereTheyNeedShift) {
  EXPECT_EQ(layout_key('6', "-"), '6');
  EXPECT_EQ(layout_key('1', "&"), '1');
}

TEST(LayoutKey, PlusAndMinusAreFoundOnEveryKeyboardAndOnTheNumberPad) {
  EXPECT_EQ(layout_key(']', "+"), '=');  // German
  EXPECT_EQ(layout_key('/', "-"), '-');
  EXPECT_EQ(layout_key(334, "+"), '=');
  EXPECT_EQ(layout_key(333, "-"), '-');
  EXPECT_EQ(layout_key(335, nullptr), 257);
}

TEST(LayoutKey, KeysWithoutASignAndSignsOfSeveralBytesStay) {
  EXPECT_EQ(layout_key(256, nullptr), 256);
  EXPECT_EQ(layout_key(';', "\xc3\xb6"), ';');
}

}  // namespace
}  // namespace stemwise
