#include "io/read_control_points.hpp"

#include <algorithm>
#include <map>

#include "io/delimited_text.hpp"
#include "io/parse_decimal.hpp"
#include "io/text_file.hpp"

namespace stemwise {
namespace {

char likely_delimiter(const std::string& text) {
  const std::string head = text.substr(0, text.find('\n'));
  char best = ',';
  for (const char c : {';', '\t'}) {
    if (std::count(head.begin(), head.end(), c) > std::count(head.begin(), head.end(), best)) best = c;
  }
  return best;
}

class ControlReader {
 public:
  ControlReader(const std::string& path, const Grid& grid) : path_(path), grid_(grid) {
    for (std::size_t c = 0; c < grid.rows.front().cells.size(); ++c) {
      std::string name = grid.rows.front().cells[c];
      std::transform(name.begin(), name.end(), name.begin(), [](unsigned char ch) { return static_cast<char>(std::tolower(ch)); });
      columns_[name] = c;
    }
  }

  Result<std::vector<ControlRow>> read() {
    const bool placed = columns_.contains("tree_id") || (columns_.contains("x_m") && columns_.contains("y_m"));
    if (!placed || !columns_.contains("lon") || !columns_.contains("lat")) {
      return Result<std::vector<ControlRow>>::failure(
          Issue{Severity::error, path_, grid_.rows.front().row, "", "the header lacks columns", "expected x_m, y_m (or tree_id), lon, lat, and height_m where known"});
    }
    std::vector<ControlRow> rows;
    for (std::size_t i = 1; i < grid_.rows.size(); ++i) {
      if (auto row = read_row(grid_.rows[i])) rows.push_back(*row);
    }
    if (!rows.empty()) return {rows, issues_};
    issues_.push_back({Severity::error, path_, 0, "", "has no usable control point", ""});
    return Result<std::vector<ControlRow>>::failure(issues_);
  }

 private:
  std::string cell(const GridRow& row, const char* name) const {
    const auto found = columns_.find(name);
    return found == columns_.end() || found->second >= row.cells.size() ? "" : row.cells[found->second];
  }

  /// A number where the cell has one; an issue where it has something else, or nothing and the row needs it.
  std::optional<double> number(const GridRow& row, const char* name, bool needed) {
    const std::string text = cell(row, name);
    if (text.empty() && !needed) return std::nullopt;
    const std::optional<double> value = parse_decimal(text);
    if (!value) issues_.push_back({Severity::warning, path_, row.row, name, text.empty() ? "is empty, the row is left out" : "'" + text + "' is no number, the row is left out", ""});
    return value;
  }

  std::optional<ControlRow> read_row(const GridRow& row) {
    ControlRow control;
    control.row = row.row;
    control.tree_id = cell(row, "tree_id");
    if (control.tree_id.empty()) {
      const auto x = number(row, "x_m", true), y = number(row, "y_m", true), z = number(row, "z_m", false);
      if (!x || !y) return std::nullopt;
      control.in_reference_m = Eigen::Vector3d(*x, *y, z.value_or(0.0));
      control.has_z = z.has_value();
    }
    const auto lon = number(row, "lon", true), lat = number(row, "lat", true), height = number(row, "height_m", false);
    if (!lon || !lat) return std::nullopt;
    if (std::abs(*lat) > 90.0 || std::abs(*lon) > 360.0) {
      issues_.push_back({Severity::warning, path_, row.row, std::abs(*lat) > 90.0 ? "lat" : "lon", "is no position on the earth, the row is left out", "degrees"});
      return std::nullopt;
    }
    control.on_earth = {*lat, *lon, height.value_or(0.0)};
    control.has_height = height.has_value();
    return control;
  }

  const std::string& path_;
  const Grid& grid_;
  std::map<std::string, std::size_t> columns_;
  Issues issues_;
};

}  // namespace

Result<std::vector<ControlRow>> read_control_points(const std::string& path) {
  const Result<TextFile> file = read_text_file(path);
  if (!file) return Result<std::vector<ControlRow>>::failure(file.issues);
  const Grid grid = parse_delimited(file->text, likely_delimiter(file->text));
  if (grid.rows.empty()) return Result<std::vector<ControlRow>>::failure(Issue{Severity::error, path, 0, "", "is empty", ""});
  return ControlReader(path, grid).read();
}

}  // namespace stemwise
