#pragma once
#include <array>
#include <cstdint>

namespace stemwise {

/// What scan_decimal found: where it stopped, and the number; `clean` is false for what it leaves to parse_decimal.
struct ScannedDecimal {
  const char* end = nullptr;
  double value = 0.0;
  bool clean = false;
};

/// Reads a plain decimal number ("-12.345": a sign or none, at most 15 digits, a point or none) up to the first other
/// character, which must be there. Exactly what parse_decimal gives for that text: both numbers are exact and the division
/// rounds once.
inline ScannedDecimal scan_decimal(const char* at) {
  constexpr std::array<double, 16> powers_of_ten{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = *at == '-';
  at += negative ? 1 : 0;
  const char* const first = at;
  std::uint64_t digits = 0;  // wraps around for long numbers, which are then left alone
  unsigned digit = static_cast<unsigned>(*at) - '0';
  for (; digit <= 9; digit = static_cast<unsigned>(*++at) - '0') digits = digits * 10 + digit;
  auto count = at - first;
  std::ptrdiff_t decimals = 0;
  if (*at == '.') {
    const char* const point = at++;
    for (digit = static_cast<unsigned>(*at) - '0'; digit <= 9; digit = static_cast<unsigned>(*++at) - '0')
      digits = digits * 10 + digit;
    decimals = at - point - 1;
    count += decimals;
  }
  if (count == 0 || count > 15) return {at, 0.0, false};
  const double value = static_cast<double>(digits) / powers_of_ten[static_cast<std::size_t>(decimals)];
  return {at, negative ? -value : value, true};
}

}  // namespace stemwise
