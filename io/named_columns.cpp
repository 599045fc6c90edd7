#include "io/named_columns.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "io/parse_decimal.hpp"

namespace stemwise {

NamedColumns::NamedColumns(std::string path, const Grid& grid) : path_(std::move(path)) {
  for (std::size_t c = 0; c < grid.rows.front().cells.size(); ++c) {
    std::string name = grid.rows.front().cells[c];
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char ch) { return static_cast<char>(std::tolower(ch)); });
    columns_[name] = c;
  }
  NumberStyleVotes votes;
  for (std::size_t r = 1; r < grid.rows.size(); ++r)
    for (const std::string& text : grid.rows[r].cells) votes.add(text);
  style_ = votes.decide(true);
}

std::optional<double> NamedColumns::number_of(const std::string& text) const {
  if (!style_.decimal_comma) return parse_decimal(text);
  const Quantity quantity = parse_quantity(text, style_);
  return quantity.kind == Quantity::Kind::number && quantity.unit.empty() ? std::optional(quantity.value) : std::nullopt;
}

std::string NamedColumns::cell(const GridRow& row, const char* name) const {
  const auto found = columns_.find(name);
  return found == columns_.end() || found->second >= row.cells.size() ? "" : row.cells[found->second];
}

std::optional<double> NamedColumns::number(const GridRow& row, const char* name, bool needed) {
  const std::string text = cell(row, name);
  if (text.empty() && !needed) return std::nullopt;
  const std::optional<double> value = number_of(text);
  if (!value) bad_cell(row, name, text.empty() ? "is empty, the row is left out" : "'" + text + "' is no number, the row is left out", "");
  return value;
}

std::optional<std::pair<double, double>> NamedColumns::lat_lon(const GridRow& row) {
  const auto lon = number(row, "lon", true), lat = number(row, "lat", true);
  if (!lon || !lat) return std::nullopt;
  if (std::abs(*lat) <= 90.0 && std::abs(*lon) <= 360.0) return std::pair(*lat, *lon);
  bad_cell(row, std::abs(*lat) > 90.0 ? "lat" : "lon", "is no position on the earth, the row is left out", "degrees");
  return std::nullopt;
}

void NamedColumns::bad_cell(const GridRow& row, const char* name, const std::string& text, const std::string& help) {
  issues_.push_back({Severity::warning, path_, row.row, name, text, help});
}

char likely_delimiter(const std::string& text) {
  const std::string head = text.substr(0, text.find('\n'));
  char best = ',';
  for (const char c : {';', '\t'}) {
    if (std::count(head.begin(), head.end(), c) > std::count(head.begin(), head.end(), best)) best = c;
  }
  return best;
}

}  // namespace stemwise
