#pragma once
#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace stemwise {

/// A day in the proleptic Gregorian calendar, as days since 1970-01-01. No time zone: a survey has days, not instants.
struct Date {
  int days = 0;
  auto operator<=>(const Date&) const = default;
};

Date date_from_civil(int year, int month, int day);
/// "2023-05-04".
std::string to_string(Date date);
/// Reads YYYY-MM-DD, YYYY/MM/DD, DD.MM.YYYY, YYYYMMDD, YYYY-MM and YYYY (mid-year: 1 July); also with a time behind it.
/// Nothing when it is none of these. Slashed DD/MM/YYYY against MM/DD/YYYY is refused unless one part exceeds 12.
std::optional<Date> parse_date(std::string_view text);
/// Years of 365.25 days from a to b, negative when b is earlier.
double years_between(Date a, Date b);
int year_of(Date date);

}  // namespace stemwise
