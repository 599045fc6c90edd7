#include "core/forest/time_order.hpp"

#include <gmock/gmock.h>

namespace stemwise {
namespace {

using ::testing::ElementsAre;

const std::optional<Date> y2015 = date_from_civil(2015, 7, 1), y2019 = date_from_civil(2019, 7, 1), y2023 = date_from_civil(2023, 7, 1), unknown;

std::vector<std::size_t> order_of(std::vector<std::optional<Date>> dates) { return time_order(dates); }

TEST(TimeOrder, sorts_by_date_and_keeps_equal_dates_as_given) {
  EXPECT_THAT(order_of({y2023, y2015, y2019}), ElementsAre(1, 2, 0));
  EXPECT_THAT(order_of({y2019, y2015, y2019}), ElementsAre(1, 0, 2));
}

TEST(TimeOrder, leaves_surveys_without_a_date_where_they_were_given) {
  EXPECT_THAT(order_of({unknown, y2023}), ElementsAre(0, 1));
  EXPECT_THAT(order_of({y2023, unknown}), ElementsAre(0, 1));
  EXPECT_THAT(order_of({y2023, unknown, y2015}), ElementsAre(2, 1, 0));
  EXPECT_THAT(order_of({unknown, unknown}), ElementsAre(0, 1));
}

}  // namespace
}  // namespace stemwise
