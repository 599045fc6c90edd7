#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace stemwise {

/// So many bytes behind the end of a text must be readable: it is looked at eight at a time.
inline constexpr std::size_t scan_margin = 8;

/// What scan_decimal found: where it stopped, and the number; `clean` is false for what it leaves to parse_decimal.
struct ScannedDecimal {
  const char* end = nullptr;
  double value = 0.0;
  bool clean = false;
};

/// Eight characters as one number, the first one lowest.
inline std::uint64_t eight_at(const char* at) {
  std::uint64_t eight = 0;
  std::memcpy(&eight, at, sizeof eight);
  if constexpr (std::endian::native == std::endian::big) eight = __builtin_bswap64(eight);
  return eight;
}

/// Where the first of two characters stands, one of which must come.
inline const char* find_either(const char* at, char a, char b) {
  constexpr std::uint64_t ones = 0x0101010101010101, highest = 0x8080808080808080;
  const auto zeros = [](std::uint64_t v) { return (v - ones) & ~v & highest; };  // the lowest bit that is set is right
  for (;; at += 8) {
    const std::uint64_t eight = eight_at(at);
    const std::uint64_t found = zeros(eight ^ (ones * static_cast<unsigned char>(a))) | zeros(eight ^ (ones * static_cast<unsigned char>(b)));
    if (found != 0) return at + std::countr_zero(found) / 8;
  }
}

/// The digits at the beginning of eight characters: how many, and their number.
struct EightDigits {
  std::ptrdiff_t count;
  std::uint64_t number;
};
inline EightDigits digits_of(std::uint64_t eight) {
  eight ^= 0x3030303030303030;
  const std::uint64_t others = ((eight + 0x7676767676767676) | eight) & 0x8080808080808080;  // the lowest bit that is set is right
  const int count = others == 0 ? 8 : std::countr_zero(others) / 8;
  if (count == 0) return {0, 0};
  eight <<= 64 - 8 * count;  // zeros before them
  eight = (eight * 2561 >> 8) & 0x00ff00ff00ff00ff;
  eight = (eight * 6553601 >> 16) & 0x0000ffff0000ffff;
  return {count, eight * 42949672960001 >> 32};
}

/// Reads a plain decimal number ("-12.345": a sign or none, at most 15 digits, a point or none) up to the first other
/// character, which must be there, with `scan_margin` bytes behind it. Exactly what parse_decimal gives for that text: both
/// numbers are exact and the division rounds once.
inline ScannedDecimal scan_decimal(const char* at) {
  constexpr std::array<double, 16> powers_of_ten{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  constexpr std::array<std::uint64_t, 9> shifts{1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
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
    for (EightDigits some{8, 0}; some.count == 8 && at - point <= 16;) {
      some = digits_of(eight_at(at));
      digits = digits * shifts[static_cast<std::size_t>(some.count)] + some.number;
      at += some.count;
    }
    decimals = at - point - 1;
    count += decimals;
  }
  if (count == 0 || count > 15) return {at, 0.0, false};
  const double value = static_cast<double>(digits) / powers_of_ten[static_cast<std::size_t>(decimals)];
  return {at, negative ? -value : value, true};
}

}  // namespace stemwise
