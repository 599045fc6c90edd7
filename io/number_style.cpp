#include "io/number_style.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "io/delimited_text.hpp"
#include "io/parse_decimal.hpp"

namespace stemwise {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// Digits, signs, and the two signs in doubt; nothing else.
bool looks_numeric(std::string_view text) {
  bool digit = false;
  for (const char c : text) {
    if (is_digit(c)) digit = true;
    else if (c != '.' && c != ',' && c != '-' && c != '+' && c != ' ') return false;
  }
  return digit;
}

/// True when `sign` stands where a thousands sign could: one to three digits, not 0 alone, then groups of three.
bool grouped(std::string_view text, char sign) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  const std::size_t first = text.find(sign);
  if (first == std::string_view::npos || first == 0 || first > 3 || text[0] == '0') return false;
  std::size_t at = first;
  while (at < text.size() && text[at] == sign) {
    std::size_t digits = 0;
    while (at + 1 + digits < text.size() && is_digit(text[at + 1 + digits])) ++digits;
    if (digits != 3) return false;
    at += 4;
  }
  return true;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 12> unit_suffixes = {{{"°", "deg"},
                                                                                          {"deg", "deg"},
                                                                                          {"gon", "gon"},
                                                                                          {"mm", "mm"},
                                                                                          {"cm", "cm"},
                                                                                          {"dm", "dm"},
                                                                                          {"ft", "ft"},
                                                                                          {"in", "in"},
                                                                                          {"rad", "rad"},
                                                                                          {"m", "m"},
                                                                                          {"'", "ft"},
                                                                                          {"\"", "in"}}};

/// Takes a unit off the end of the number.
std::string_view take_unit(std::string_view& text) {
  for (const auto& [suffix, unit] : unit_suffixes) {
    if (text.size() <= suffix.size()) continue;
    const std::string_view end = text.substr(text.size() - suffix.size());
    if (lower(end) != suffix) continue;
    const std::string_view number = trimmed(text.substr(0, text.size() - suffix.size()));
    if (number.empty() || (!is_digit(number.back()) && number.back() != '.')) continue;
    text = number;
    return unit;
  }
  return {};
}

/// Length of the blank, no-break blank or apostrophe that a group of exactly three digits follows; else 0.
std::size_t group_sign_length(std::string_view text) {
  static constexpr std::array<std::string_view, 5> signs = {" ", "'", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x99"};
  for (const std::string_view sign : signs) {
    if (!text.starts_with(sign)) continue;
    const std::string_view rest = text.substr(sign.size());
    const auto digits = static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), is_digit) - rest.begin());
    return digits == 3 ? sign.size() : 0;
  }
  return 0;
}

/// With a point as decimal sign and no thousands signs.
std::string plain_number(std::string_view text, bool decimal_comma) {
  const char decimal = decimal_comma ? ',' : '.';
  const char thousands = decimal_comma ? '.' : ',';
  const std::string_view whole = text.substr(0, text.find(decimal));
  const bool has_groups = grouped(whole, thousands);
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == thousands && has_groups) continue;
    if (const std::size_t length = i > 0 && is_digit(text[i - 1]) ? group_sign_length(text.substr(i)) : 0; length > 0) {
      i += length - 1;
      continue;
    }
    out.push_back(c == decimal ? '.' : c);
  }
  return out;
}

}  // namespace

void NumberStyleVotes::add(std::string_view text) {
  const std::size_t point = text.rfind('.');
  const std::size_t comma = text.rfind(',');
  const bool has_point = point != std::string_view::npos;
  const bool has_comma = comma != std::string_view::npos;
  if ((!has_point && !has_comma) || !looks_numeric(text)) return;
  if (has_point && has_comma) {
    ++(point > comma ? point_decimal_ : comma_decimal_);
  } else if (has_comma) {
    if (text.find(',') != comma) ++point_decimal_;
    else if (grouped(text, ',')) ++doubtful_comma_;
    else ++comma_decimal_;
  } else if (text.find('.') != point) {
    ++comma_decimal_;
  } else if (!grouped(text, '.')) {
    ++point_decimal_;
  }
}

NumberStyle NumberStyleVotes::decide(bool comma_delimits) const {
  if (comma_decimal_ != point_decimal_) return {comma_decimal_ > point_decimal_, true};
  if (comma_decimal_ > 0) return {!comma_delimits, false};
  if (doubtful_comma_ > 0) return {!comma_delimits, false};
  return {false, true};
}

bool is_missing_mark(std::string_view cell) {
  static constexpr std::array<std::string_view, 14> marks = {"", "na", "n/a", "#n/a", "null", "<null>", "none", "nil", "nm", "-", "--", ".", "?", "nd"};
  if (cell.size() > 6) return false;
  return std::find(marks.begin(), marks.end(), lower(cell)) != marks.end();
}

Quantity parse_quantity(std::string_view cell, NumberStyle style) {
  Quantity quantity;
  if (is_missing_mark(cell)) return quantity;
  if (const auto plain = parse_decimal(cell); plain && !(style.decimal_comma && grouped(cell, '.'))) {
    return {Quantity::Kind::number, *plain, {}};
  }
  std::string_view text = trimmed(cell);
  quantity.unit = take_unit(text);
  for (const bool comma : {style.decimal_comma, !style.decimal_comma}) {
    if (const auto value = parse_decimal(plain_number(text, comma))) {
      quantity.kind = Quantity::Kind::number;
      quantity.value = *value;
      return quantity;
    }
  }
  const std::string word = lower(text);
  const bool not_finite = word == "nan" || word == "#nan" || word == "inf" || word == "-inf" || word == "infinity" || word == "-nan" || word == "#num!";
  quantity.kind = not_finite ? Quantity::Kind::not_a_number : Quantity::Kind::bad;
  return quantity;
}

}  // namespace stemwise
