#include "io/read_gnss_track.hpp"

#include <cstdio>

#include "core/base/date.hpp"
#include "io/delimited_text.hpp"
#include "io/named_columns.hpp"
#include "io/text_file.hpp"

namespace stemwise {
namespace {

using Fixes = Result<std::vector<GnssFix>>;

std::optional<double> seconds_of(const NamedColumns& columns, const std::string& text) {
  if (const auto number = columns.number_of(text)) return number;
  int year = 0, month = 0, day = 0, hour = 0, minute = 0;
  double second = 0.0;
  char between = 0;
  if (std::sscanf(text.c_str(), "%4d-%2d-%2d%c%2d:%2d:%lf", &year, &month, &day, &between, &hour, &minute, &second) != 7) return std::nullopt;
  if ((between != 'T' && between != ' ') || month < 1 || month > 12 || day < 1 || day > 31 || hour > 23 || minute > 59 || second >= 61.0) return std::nullopt;
  return 86400.0 * date_from_civil(year, month, day).days + 3600.0 * hour + 60.0 * minute + second;
}

std::optional<GnssFix> read_row(const GridRow& row, NamedColumns& columns) {
  GnssFix fix;
  const auto seconds = seconds_of(columns, columns.cell(row, "timestamp"));
  if (!seconds) {
    columns.bad_cell(row, "timestamp", "'" + columns.cell(row, "timestamp") + "' is no time, the row is left out", "expected seconds, or 2023-05-04T10:15:00Z");
    return std::nullopt;
  }
  const auto at = columns.lat_lon(row);
  if (!at) return std::nullopt;
  const auto height = columns.number(row, "height_m", false);
  fix.timestamp_s = *seconds;
  fix.on_earth = {at->first, at->second, height.value_or(0.0)};
  fix.has_height = height.has_value();
  fix.sd_m = columns.number(row, "sd_m", false);
  if (fix.sd_m && *fix.sd_m <= 0.0) fix.sd_m.reset();
  return fix;
}

}  // namespace

Fixes read_gnss_track(const std::string& path) {
  const Result<TextFile> file = read_text_file(path);
  if (!file) return Fixes::failure(file.issues);
  const Grid grid = parse_delimited(file->text, likely_delimiter(file->text));
  if (grid.rows.empty()) return Fixes::failure(Issue{Severity::error, path, 0, "", "is empty", ""});
  NamedColumns columns(path, grid);
  if (!columns.has("timestamp") || !columns.has("lat") || !columns.has("lon"))
    return Fixes::failure(Issue{Severity::error, path, grid.rows.front().row, "", "the header lacks columns", "expected timestamp, lat, lon, and height_m, sd_m where known"});
  std::vector<GnssFix> fixes;
  for (std::size_t i = 1; i < grid.rows.size(); ++i)
    if (auto fix = read_row(grid.rows[i], columns)) fixes.push_back(*fix);
  if (!fixes.empty()) return {fixes, columns.issues()};
  columns.issues().push_back({Severity::error, path, 0, "", "has no usable fix", ""});
  return Fixes::failure(columns.issues());
}

}  // namespace stemwise
