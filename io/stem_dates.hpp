#pragma once
#include "io/date_text.hpp"
#include "io/stem_columns.hpp"

namespace stemwise {

/// How the days of one column are written, as far as all of its cells tell.
struct DateReading {
  DayOrder order = DayOrder::unknown;
  bool serials = false;     ///< a spreadsheet's day counts
  std::string told_by;      ///< the cell that told the order

  std::optional<Date> operator()(std::string_view cell) const;
  std::string in_words() const;  ///< ", day before month (told by 13/5/2021)"; empty where nothing had to be decided
};
/// "may begin with the day or ...", or that it is none: why a cell gives no date.
std::string why_no_date(std::string_view cell);

DateReading date_reading_of(const StemTable& table, std::size_t column);

/// Among the columns named like dates the first that holds dates (ForestGEO's `date` is a count of days).
std::optional<std::size_t> choose_date_column(const StemTable& table);

/// A warning where a column is named like a date and nothing of it can be read, or where the order of day and month stays open.
Issues warn_of_unread_dates(const StemTable& table, const StemColumns& columns, const ReadOptions& options);

/// The inventory's date: as told, else the median of its stems', else by the census's header, else from the name.
void set_dates(Inventory& inventory, const StemTable& table, const StemColumns& columns, const ReadOptions& options);

}  // namespace stemwise
