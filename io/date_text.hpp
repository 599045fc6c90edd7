#pragma once
#include <optional>
#include <string_view>

#include "core/base/date.hpp"

namespace stemwise {

/// Which number of 5/6/2021 is the day.
enum class DayOrder { unknown, day_first, month_first };

/// What `parse_date` reads, and more than it can: 13.5.21 (day first), 5/6/2021 and 5/6/21 by `order`, 13-May-2021, May 13, 2021,
/// 13. Mai 2021, 13 de mayo de 2021, mai 2021, 2021.0. Two digits of a year are 1950 to 2049.
std::optional<Date> date_from_text(std::string_view text, DayOrder order = DayOrder::unknown);

/// What one date with slashes tells of the order: 13/5/2021 says day first; unknown where it says nothing.
DayOrder order_told_by(std::string_view text);

/// A spreadsheet's count of days since the end of 1899, from 1980 to 2099: 44329 is 2021-05-13.
std::optional<Date> date_from_serial(std::string_view text);

}  // namespace stemwise
