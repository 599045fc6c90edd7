#include "ui/text/number_from_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace stemwise::ui {
namespace {

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
}

bool is_digits(const std::string& text) { return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }); }

/// "1234" of "1.234"; nothing unless all groups behind the first have three digits.
std::optional<std::string> without_groups(const std::string& text, const std::string& separators) {
  std::string digits;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    const std::string group = text.substr(at, end - at);
    const bool is_first = at == 0, is_only = is_first && end == text.size();
    if (!is_digits(group) || (!is_only && (is_first ? group.size() > 3 : group.size() != 3))) return std::nullopt;
    digits += group;
    at = end + 1;
  }
  return digits;
}

/// Where the decimals begin: the last of points and commas, unless there are several of one kind and none of the other.
std::size_t decimal_sign(const std::string& text) {
  const std::size_t last = text.find_last_of(".,");
  if (last == std::string::npos) return last;
  const char sign = text[last], other = sign == '.' ? ',' : '.';
  const bool repeated = std::count(text.begin(), text.end(), sign) > 1;
  return repeated && text.find(other) == std::string::npos ? std::string::npos : last;
}

}  // namespace

std::optional<double> number_from_text(const std::string& typed) {
  std::string text = typed;
  replace_all(text, "\u2212", "-");
  for (const char* blank : {"\u00a0", "\u202f", "\u2009"}) replace_all(text, blank, " ");
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  std::string sign, exponent;
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) sign = text.front() == '-' ? "-" : "", text.erase(0, 1);
  if (const std::size_t e = text.find_first_of("eE"); e != std::string::npos) exponent = text.substr(e), text.erase(e);
  const std::size_t point = decimal_sign(text);
  const std::string decimals = point == std::string::npos ? "" : text.substr(point + 1);
  const std::string separators = point == std::string::npos ? ".,' " : text[point] == '.' ? ",' " : ".' ";
  const std::string front = text.substr(0, point);
  const std::optional<std::string> whole = front.empty() && !decimals.empty() ? std::optional<std::string>("0") : without_groups(front, separators);
  if (!whole || (!decimals.empty() && !is_digits(decimals))) return std::nullopt;
  const std::string plain = sign + *whole + "." + decimals + exponent;
  char* end = nullptr;
  const double value = std::strtod(plain.c_str(), &end);
  if (end != plain.c_str() + plain.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace stemwise::ui
