#include "ui/text/format.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace stemwise::ui {
namespace {

constexpr const char* minus = "−";
constexpr const char* thin_space = "\xE2\x80\x89";

std::string magnitude(double value, int decimals) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, std::abs(value));
  return buffer.data();
}

bool shows_as_zero(const std::string& digits) { return digits.find_first_not_of("0.") == std::string::npos; }

std::string group_digits(const std::string& digits, const char* separator) {
  const std::size_t whole = std::min(digits.find('.'), digits.size());
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && i < whole && (whole - i) % 3 == 0) out += separator;
    out += digits[i];
  }
  return out;
}

}  // namespace

std::string fixed(double value, int decimals) {
  const std::string digits = magnitude(value, decimals);
  return value < 0.0 && !shows_as_zero(digits) ? minus + digits : digits;
}

std::string count_text(std::int64_t count) { return (count < 0 ? minus : "") + group_digits(magnitude(static_cast<double>(count), 0), ","); }

std::string plural(std::int64_t count, const char* one, const char* many) { return count_text(count) + " " + (count == 1 ? one : many); }

std::string dbh_text(std::optional<double> dbh_m) { return dbh_m ? fixed(*dbh_m * 100.0, 1) : dash; }

std::string change_text(std::optional<double> change_m) {
  if (!change_m) return dash;
  const std::string text = fixed(*change_m * 100.0, 1);
  return *change_m > 0.0 && !shows_as_zero(text) ? "+" + text : text;
}

std::string distance_text(double distance_m) { return fixed(distance_m, 2) + " m"; }

std::string residual_text(double residual_m) { return fixed(residual_m * 100.0, residual_m < 0.995 ? 1 : 0) + " cm"; }

std::string grouped(double value, int decimals) {
  return (value < 0.0 ? minus : "") + group_digits(magnitude(value, decimals), thin_space);
}

std::string date_text(Date date) {
  static constexpr const char* months[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const std::string iso = to_string(date);  // YYYY-MM-DD
  const int month = std::stoi(iso.substr(iso.size() - 5, 2));
  const int day = std::stoi(iso.substr(iso.size() - 2, 2));
  return std::to_string(day) + " " + months[month - 1] + " " + iso.substr(0, iso.size() - 6);
}

std::string percent_text(double share, int decimals) { return fixed(share * 100.0, decimals) + " %"; }

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

std::string flag_words(std::string flag) {
  std::replace(flag.begin(), flag.end(), '_', ' ');
  return flag;
}

std::string sentence(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string ago_text(double seconds) {
  if (seconds < 60.0) return std::to_string(static_cast<long>(seconds)) + " s ago";
  if (seconds < 3600.0) return std::to_string(static_cast<long>(seconds / 60.0)) + " min ago";
  return std::to_string(static_cast<long>(seconds / 3600.0)) + " h ago";
}

}  // namespace stemwise::ui
