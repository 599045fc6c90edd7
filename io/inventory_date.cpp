#include "io/inventory_date.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace stemwise {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool plausible(Date date) { return year_of(date) >= 1850 && year_of(date) <= 2100; }

}  // namespace

std::optional<Date> date_from_name(const std::string& path) {
  const std::string name = inventory_name(path);
  std::optional<Date> found;
  std::size_t best_length = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_digit(name[i]) || (i > 0 && is_digit(name[i - 1]))) continue;
    for (const std::size_t length : {std::size_t{10}, std::size_t{8}, std::size_t{7}, std::size_t{4}}) {
      if (i + length > name.size() || (i + length < name.size() && is_digit(name[i + length]))) continue;
      std::string text = name.substr(i, length);
      std::replace(text.begin(), text.end(), '_', '-');
      if (!is_digit(text.back())) continue;
      const auto date = parse_date(text);
      if (!date || !plausible(*date) || length < best_length) continue;
      found = date;
      best_length = length;
      i += length - 1;
      break;
    }
  }
  return found;
}

std::optional<Date> median_date(std::vector<Date> dates) {
  if (dates.empty()) return std::nullopt;
  const auto middle = dates.begin() + static_cast<std::ptrdiff_t>(dates.size() / 2);
  std::nth_element(dates.begin(), middle, dates.end());
  return *middle;
}

std::string inventory_name(const std::string& path) {
  std::filesystem::path p(path);
  if (!p.has_filename()) p = p.parent_path();
  std::error_code error;
  if (p == "." || p == "..") p = std::filesystem::weakly_canonical(p, error);
  return std::filesystem::is_directory(p, error) ? p.filename().string() : p.stem().string();
}

}  // namespace stemwise
