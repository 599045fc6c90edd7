#include "ui/text/number_from_text.hpp"

#include <gtest/gtest.h>

namespace stemwise::ui {
namespace {

TEST(NumberFromText, TakesPointAndCommaAndThousandsApart) {
  const std::pair<const char*, double> cases[] = {{"1.5", 1.5}, {"1,5", 1.5}, {"-0,25", -0.25}, {"\u22123", -3.0}, {"1.234,5", 1234.5}, {"1,234.5", 1234.5}, {"1 234,5", 1234.5},
                                                  {"1'234.5", 1234.5}, {"12.345.678", 12345678.0}, {"1\u202f234", 1234.0}, {"5402020,5", 5402020.5}, {".5", 0.5}, {"7.", 7.0},
                                                  {" 3 ", 3.0}, {"1e-3", 0.001}, {"1,5E2", 150.0}, {"+4", 4.0}};
  for (const auto& [text, value] : cases) {
    const auto read = number_from_text(text);
    ASSERT_TRUE(read) << text;
    EXPECT_DOUBLE_EQ(*read, value) << text;
  }
}

TEST(NumberFromText, RefusesWhatIsNoNumberOrCutInTheWrongPlaces) {
  for (const char* text : {"", "abc", "1.37,5", "12,,5", "1'5", "1.2.3", "1,2,3", "1 23", "--1", "1-2", "e5", "1e", "inf", "nan", "0x10", "1.5 m", ".", ",", "1e999"}) {
    EXPECT_FALSE(number_from_text(text)) << text;
  }
}

}  // namespace
}  // namespace stemwise::ui
