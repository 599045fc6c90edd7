#include "io/report/number_text.hpp"

#include <cstdio>

namespace stemwise {

std::string fixed(double value, int decimals) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  const bool is_zero = std::string(text).find_first_not_of("-0.") == std::string::npos;
  return is_zero && text[0] == '-' ? text + 1 : text;
}

std::string fixed(const std::optional<double>& value, int decimals, double factor) { return value ? fixed(*value * factor, decimals) : ""; }

std::string date_text(const std::optional<Date>& date) { return date ? to_string(*date) : ""; }

std::string grouped(int value) {
  std::string digits = std::to_string(value);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) digits.insert(static_cast<std::size_t>(at), ",");
  return digits;
}

}  // namespace stemwise
