#include "core/base/date.hpp"

#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>

namespace stemwise {
namespace {

std::chrono::year_month_day civil(Date date) {
  return std::chrono::year_month_day{std::chrono::sys_days{std::chrono::days{date.days}}};
}

std::optional<Date> checked(int year, int month, int day) {
  using namespace std::chrono;
  const year_month_day ymd{std::chrono::year{year}, std::chrono::month{static_cast<unsigned>(month)},
                           std::chrono::day{static_cast<unsigned>(day)}};
  if (year < 1500 || year > 2500 || month < 1 || day < 1 || !ymd.ok()) return std::nullopt;
  return Date{static_cast<int>(sys_days{ymd}.time_since_epoch().count())};
}

struct Parts {
  std::array<int, 3> number{};
  std::array<std::size_t, 3> digits{};
  std::size_t count = 0;
  char separator = 0;
};

/// Splits "2023-05-04" into its numbers; a blank or 'T' ends the date.
std::optional<Parts> split(std::string_view text) {
  Parts parts;
  while (!text.empty() && parts.count < 3) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || number < 0) return std::nullopt;
    const auto used = static_cast<std::size_t>(end - text.data());
    parts.number[parts.count] = number;
    parts.digits[parts.count++] = used;
    text.remove_prefix(used);
    if (text.empty() || text.front() == ' ' || text.front() == 'T') return parts;
    if (parts.count == 3) return std::nullopt;
    const char c = text.front();
    if ((c != '-' && c != '/' && c != '.') || (parts.separator != 0 && c != parts.separator)) return std::nullopt;
    parts.separator = c;
    text.remove_prefix(1);
  }
  return std::nullopt;
}

}  // namespace

Date date_from_civil(int year, int month, int day) { return checked(year, month, day).value_or(Date{}); }

std::string to_string(Date date) {
  const auto ymd = civil(date);
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%04d-%02u-%02u", static_cast<int>(ymd.year()), static_cast<unsigned>(ymd.month()),
                static_cast<unsigned>(ymd.day()));
  return buffer.data();
}

std::optional<Date> parse_date(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  const auto parts = split(text);
  if (!parts) return std::nullopt;
  const auto& n = parts->number;
  if (parts->count == 1 && parts->digits[0] == 8) return checked(n[0] / 10000, n[0] / 100 % 100, n[0] % 100);
  if (parts->count == 1 && parts->digits[0] == 4) return checked(n[0], 7, 1);
  if (parts->count == 2 && parts->digits[0] == 4) return checked(n[0], n[1], 15);
  if (parts->count != 3) return std::nullopt;
  if (parts->digits[0] == 4) return checked(n[0], n[1], n[2]);
  if (parts->digits[2] != 4) return std::nullopt;
  if (parts->separator == '.') return checked(n[2], n[1], n[0]);
  if (n[0] > 12) return checked(n[2], n[1], n[0]);
  if (n[1] > 12 || n[0] == n[1]) return checked(n[2], n[0], n[1]);
  return std::nullopt;
}

double years_between(Date a, Date b) { return (b.days - a.days) / 365.25; }

int year_of(Date date) { return static_cast<int>(civil(date).year()); }

}  // namespace stemwise
