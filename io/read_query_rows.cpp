#include "io/read_query_rows.hpp"

#include <array>
#include <optional>

#include "io/delimited_text.hpp"
#include "io/parse_decimal.hpp"
#include "io/text_file.hpp"

namespace stemwise {
namespace {

constexpr std::array columns{"query", "candidate", "positive", "score", "dx_m", "dy_m", "dz_m", "droll_deg", "dpitch_deg", "dyaw_deg"};
using Places = std::array<std::size_t, columns.size()>;

/// The row, or the column that holds no number.
struct ReadRow {
  QueryResult row;
  const char* bad_column = nullptr;
};
ReadRow row_from(const std::vector<std::string>& cells, const Places& places) {
  ReadRow read;
  std::array<double, columns.size()> value{};
  const auto cell = [&](std::size_t c) { return places[c] < cells.size() ? trimmed(cells[places[c]]) : std::string_view{}; };
  const bool found = !cell(1).empty();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (!found && (c == 1 || c >= 4)) continue;
    const auto number = parse_decimal(cell(c));
    if (!number) return {{}, columns[c]};
    value[c] = *number;
  }
  read.row.query = static_cast<std::int64_t>(value[0]);
  read.row.candidate = found ? static_cast<std::int64_t>(value[1]) : -1;
  read.row.positive = value[2] != 0.0;
  read.row.score = value[3];
  for (std::size_t i = 0; i < 3; ++i) {
    read.row.position_m[i] = value[4 + i];
    read.row.angle_deg[i] = value[7 + i];
  }
  return read;
}

}  // namespace

Result<std::vector<QueryResult>> read_query_rows(const std::string& path) {
  const auto file = read_text_file(path);
  if (!file) return Result<std::vector<QueryResult>>::failure(file.issues);
  const auto fail = [&](const std::string& column, const std::string& text) {
    return Result<std::vector<QueryResult>>::failure(
        Issue{Severity::error, path, 1, column, text, "it takes files that stemwise evaluate intra or inter wrote with --csv"});
  };
  const Grid grid = parse_delimited(file->text, ',');
  if (grid.rows.empty()) return fail("", "has no header");
  Places places{};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    places[c] = grid.rows[0].cells.size();
    for (std::size_t i = 0; i < grid.rows[0].cells.size(); ++i) {
      if (trimmed(grid.rows[0].cells[i]) == columns[c]) places[c] = i;
    }
    if (places[c] == grid.rows[0].cells.size()) return fail(columns[c], "there is no such column");
  }
  Result<std::vector<QueryResult>> result;
  std::vector<QueryResult> rows;
  for (std::size_t r = 1; r < grid.rows.size(); ++r) {
    const ReadRow read = row_from(grid.rows[r].cells, places);
    if (read.bad_column == nullptr) {
      rows.push_back(read.row);
    } else {
      result.issues.push_back({Severity::warning, path, grid.rows[r].row, read.bad_column, "holds no number; the row is left out", ""});
    }
  }
  if (rows.empty()) return fail("", "has no usable row");
  result.value = std::move(rows);
  return result;
}

}  // namespace stemwise
