#include "io/parse_decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace stemwise {
namespace {

constexpr std::array<double, 23> powers_of_ten{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                               1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t exact_limit = 1ULL << 53;

std::optional<double> parse_slowly(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_decimal(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  const char* at = text.data();
  const char* const end = at + text.size();
  const bool negative = at != end && *at == '-';
  if (at != end && (*at == '-' || *at == '+')) ++at;
  std::uint64_t digits = 0;
  int count = 0;
  const char* point = nullptr;
  for (; at != end; ++at) {
    const unsigned digit = static_cast<unsigned>(*at) - '0';
    if (digit <= 9) {
      digits = digits * 10 + digit;
      ++count;
    } else if (*at == '.' && point == nullptr) {
      point = at;
    } else {
      return parse_slowly(text);
    }
  }
  if (count == 0) return std::nullopt;
  const auto decimals = point == nullptr ? 0 : static_cast<std::size_t>(end - point - 1);
  // Both numbers exact in double, one rounding: the division is correctly rounded.
  if (count > 18 || digits >= exact_limit || decimals >= powers_of_ten.size()) return parse_slowly(text);
  const double value = static_cast<double>(digits) / powers_of_ten[decimals];
  return negative ? -value : value;
}

}  // namespace stemwise
