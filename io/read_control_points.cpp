#include "io/read_control_points.hpp"

#include "io/delimited_text.hpp"
#include "io/named_columns.hpp"
#include "io/text_file.hpp"

namespace stemwise {
namespace {

using Rows = Result<std::vector<ControlRow>>;

std::optional<ControlRow> read_row(const GridRow& row, NamedColumns& columns) {
  ControlRow control;
  control.row = row.row;
  control.tree_id = columns.cell(row, "tree_id");
  if (control.tree_id.empty()) {
    const auto x = columns.number(row, "x_m", true), y = columns.number(row, "y_m", true), z = columns.number(row, "z_m", false);
    if (!x || !y) return std::nullopt;
    control.in_reference_m = Eigen::Vector3d(*x, *y, z.value_or(0.0));
    control.has_z = z.has_value();
  }
  const auto at = columns.lat_lon(row);
  const auto height = columns.number(row, "height_m", false);
  if (!at) return std::nullopt;
  control.on_earth = {at->first, at->second, height.value_or(0.0)};
  control.has_height = height.has_value();
  return control;
}

}  // namespace

Rows read_control_points(const std::string& path) {
  const Result<TextFile> file = read_text_file(path);
  if (!file) return Rows::failure(file.issues);
  const Grid grid = parse_delimited(file->text, likely_delimiter(file->text));
  if (grid.rows.empty()) return Rows::failure(Issue{Severity::error, path, 0, "", "is empty", ""});
  NamedColumns columns(path, grid);
  const bool placed = columns.has("tree_id") || (columns.has("x_m") && columns.has("y_m"));
  if (!placed || !columns.has("lon") || !columns.has("lat"))
    return Rows::failure(Issue{Severity::error, path, grid.rows.front().row, "", "the header lacks columns", "expected x_m, y_m (or tree_id), lon, lat, and height_m where known"});
  std::vector<ControlRow> rows;
  for (std::size_t i = 1; i < grid.rows.size(); ++i)
    if (auto row = read_row(grid.rows[i], columns)) rows.push_back(*row);
  if (!rows.empty()) return {rows, columns.issues()};
  columns.issues().push_back({Severity::error, path, 0, "", "has no usable control point", ""});
  return Rows::failure(columns.issues());
}

}  // namespace stemwise
