#include "core/base/field.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>

namespace stemwise {
namespace {

template <class Number>
bool parse_number(const std::string& text, Number& out) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(static_cast<double>(number))) return false;
  out = number;
  return true;
}

bool parse_into(const Field& field, const std::string& text) {
  if (auto* const* d = std::get_if<double*>(&field.value)) return parse_number(text, **d);
  if (auto* const* i = std::get_if<int*>(&field.value)) return parse_number(text, **i);
  if (auto* const* s = std::get_if<std::string*>(&field.value)) {
    **s = text;
    return true;
  }
  bool& flag = *std::get<bool*>(field.value);
  if (text == "true" || text == "1" || text == "yes" || text == "on") return flag = true, true;
  if (text == "false" || text == "0" || text == "no" || text == "off") return flag = false, true;
  return false;
}

const char* expected(const Field& field) {
  constexpr std::array names{"a number", "a whole number", "true or false", "text"};
  return names[field.value.index()];
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row.back();
}

}  // namespace

std::string field_text(const Field& field) {
  if (auto* const* d = std::get_if<double*>(&field.value)) {
    std::array<char, 32> buffer{};
    return std::string(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), **d).ptr);
  }
  if (auto* const* i = std::get_if<int*>(&field.value)) return std::to_string(**i);
  if (auto* const* b = std::get_if<bool*>(&field.value)) return **b ? "true" : "false";
  return *std::get<std::string*>(field.value);
}

Issues set_field(std::span<const Field> fields, const std::string& key, const std::string& text) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.key == key; });
  if (found == fields.end()) {
    const auto nearest = std::min_element(fields.begin(), fields.end(), [&](const Field& a, const Field& b) {
      return edit_distance(a.key, key) < edit_distance(b.key, key);
    });
    const std::string help = nearest == fields.end() ? "" : "did you mean " + nearest->key + "?";
    return {{Severity::error, "", 0, key, "there is no such setting", help}};
  }
  if (parse_into(*found, text)) return {};
  return {{Severity::error, "", 0, key, "'" + text + "' is not " + expected(*found), found->help}};
}

}  // namespace stemwise
