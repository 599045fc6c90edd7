#include "io/date_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "io/column_names.hpp"
#include "io/parse_decimal.hpp"

namespace stemwise {
namespace {

/// Names and beginnings of the months in English, German, French, Spanish, Portuguese and Italian; accents removed.
const std::array<std::vector<std::string_view>, 12>& month_names() {
  static const std::array<std::vector<std::string_view>, 12> names = {
      {{"january", "jan", "januar", "janner", "jaenner", "janvier", "janv", "enero", "ene", "janeiro", "gennaio", "gen"},
       {"february", "feb", "februar", "feber", "fevrier", "fevr", "fev", "febrero", "fevereiro", "febbraio"},
       {"march", "mar", "marz", "maerz", "mrz", "mars", "marzo", "marco"},
       {"april", "apr", "avril", "avr", "abril", "abr", "aprile"},
       {"may", "mai", "mayo", "maio", "maggio", "mag"},
       {"june", "jun", "juni", "juin", "junio", "junho", "giugno", "giu"},
       {"july", "jul", "juli", "juillet", "juil", "julio", "julho", "luglio", "lug"},
       {"august", "aug", "aout", "agosto", "ago"},
       {"september", "sep", "sept", "septembre", "septiembre", "setiembre", "setembro", "set", "settembre"},
       {"october", "oct", "oktober", "okt", "octobre", "octubre", "outubro", "out", "ottobre", "ott"},
       {"november", "nov", "novembre", "noviembre", "novembro"},
       {"december", "dec", "dezember", "dez", "decembre", "diciembre", "dic", "dezembro", "dicembre"}}};
  return names;
}

int month_from(std::string_view word) {
  const auto& months = month_names();
  for (std::size_t m = 0; m < months.size(); ++m)
    if (std::find(months[m].begin(), months[m].end(), word) != months[m].end()) return static_cast<int>(m) + 1;
  return 0;
}

int full_year(int two) { return two < 50 ? 2000 + two : 1900 + two; }

std::optional<Date> checked(int year, int month, int day) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02d-%02d", year, month, day);
  return parse_date(text.data());
}

struct Slashed {
  int first = 0, second = 0, year = 0;
  bool whole_year = false;  ///< of four digits
};

/// Three numbers with `separator` between them, the year last and of two or four digits; a time may follow.
std::optional<Slashed> slashed(std::string_view text, char separator) {
  std::array<int, 3> numbers{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  std::ptrdiff_t digits = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc{} || numbers[i] < 0) return std::nullopt;
    digits = next - at;
    at = next;
    if (i < 2) {
      if (digits > 2 || at == end || *at != separator) return std::nullopt;
      ++at;
    }
  }
  if ((digits != 2 && digits != 4) || (at != end && *at != ' ' && *at != 'T')) return std::nullopt;
  return Slashed{numbers[0], numbers[1], digits == 2 ? full_year(numbers[2]) : numbers[2], digits == 4};
}

/// 5/6/2021, 5/6/21 and 5-6-2021; 5-6-21 may begin with its year.
std::optional<Slashed> day_and_month(std::string_view text) {
  if (const auto parts = slashed(text, '/')) return parts;
  const auto parts = slashed(text, '-');
  return parts && parts->whole_year ? parts : std::nullopt;
}

/// One word more or less: "13th" is 13; "de", "of", "le", "den" are none.
std::optional<int> number_from(const std::string& word) {
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{}) return std::nullopt;
  const std::string_view behind(end);
  const bool ordinal = behind.empty() || behind == "st" || behind == "nd" || behind == "rd" || behind == "th" || behind == "er";
  return ordinal ? std::optional(value) : std::nullopt;
}

/// A day, a month's name and a year in any order that is in use; without a day the middle of the month.
std::optional<Date> with_month_name(std::string_view text) {
  int month = 0;
  std::vector<std::pair<int, std::size_t>> numbers;  // and how many digits
  for (const std::string& word : plain_words(text)) {
    if (word == "de" || word == "of" || word == "do" || word == "del" || word == "di") continue;
    if (const auto number = number_from(word)) {
      numbers.emplace_back(*number, word.find_first_not_of("0123456789") == std::string::npos ? word.size() : 2);
    } else if (const int named = month_from(word); named != 0 && month == 0) {
      month = named;
    } else {
      return std::nullopt;
    }
    if (month != 0 && numbers.size() == 2) break;  // a time may follow
  }
  if (month == 0 || numbers.empty()) return std::nullopt;
  if (numbers.size() == 1) return numbers[0].second == 4 ? checked(numbers[0].first, month, 15) : std::nullopt;
  if (numbers[0].second == 4) std::swap(numbers[0], numbers[1]);
  const auto [year, digits] = numbers[1];
  if ((digits != 2 && digits != 4) || numbers[0].second > 2) return std::nullopt;
  return checked(digits == 2 ? full_year(year) : year, month, numbers[0].first);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

std::optional<Date> date_from_text(std::string_view text, DayOrder order) {
  text = trimmed(text);
  const bool has_word = std::count_if(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c) != 0; }) > 2;
  if (has_word)
    if (const auto date = with_month_name(text)) return date;
  if (const auto date = parse_date(text)) return date;
  if (const auto dotted = slashed(text, '.')) return checked(dotted->year, dotted->second, dotted->first);
  if (const auto parts = day_and_month(text)) {
    if (const DayOrder told = order_told_by(text); told != DayOrder::unknown) order = told;
    if (order == DayOrder::day_first || parts->first == parts->second) return checked(parts->year, parts->second, parts->first);
    return order == DayOrder::month_first ? checked(parts->year, parts->first, parts->second) : std::nullopt;
  }
  if (text.size() == 6 && text.ends_with(".0")) return parse_date(text.substr(0, 4));
  return std::nullopt;
}

DayOrder order_told_by(std::string_view text) {
  const auto parts = day_and_month(trimmed(text));
  if (!parts || (parts->first > 12) == (parts->second > 12)) return DayOrder::unknown;
  return parts->first > 12 ? DayOrder::day_first : DayOrder::month_first;
}

std::optional<Date> date_from_serial(std::string_view text) {
  constexpr double first = 29221.0, last = 73050.0;
  constexpr int days_before_1970 = 25569;
  const auto number = parse_decimal(trimmed(text));
  if (!number || *number < first || *number > last) return std::nullopt;
  return Date{static_cast<int>(std::floor(*number)) - days_before_1970};
}

}  // namespace stemwise
