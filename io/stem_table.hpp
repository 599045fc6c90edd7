#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "io/column_names.hpp"
#include "io/grid.hpp"
#include "io/number_style.hpp"
#include "io/read_inventory.hpp"

namespace stemwise {

/// A grid whose header row is known.
struct StemTable {
  std::string file;
  std::int64_t header_row = 0;
  std::vector<std::string> header;
  std::vector<ColumnName> names;  ///< of `header`
  std::vector<GridRow> rows;      ///< below the header
  NumberStyle style;
  std::vector<std::string> notes; ///< how it was read so far
  Issues issues;

  std::string_view cell(const GridRow& row, std::size_t column) const {
    return column < row.cells.size() ? std::string_view(row.cells[column]) : std::string_view();
  }
  /// Column whose header is `name` (exactly, else without regard to case, else by letters alone).
  std::optional<std::size_t> find(const std::string& name) const;
  /// The numbers of a column, in order; cells that hold none are left out.
  std::vector<double> numbers(std::size_t column) const;
};

/// A stem table with what its file says about it.
struct OpenedTable {
  StemTable table;
  std::optional<int> epsg;          ///< system of its x and y, where the file knows it
  std::string format;               ///< "table", "workbook (XLSX)", "GIS points (GPKG)"
  std::vector<std::string> sheets;  ///< of a workbook, or layers; the one that was opened is in the table's notes
};

/// How sure one is that a row of a grid is the header of a stem table: recognised columns, and more when they give
/// positions. 0: it is not.
int header_score(const GridRow& row, const ReadOptions& options);

/// Finds the header among the first rows (lines before it are a preamble). Nothing when no row looks like one.
std::optional<std::size_t> find_header(const Grid& grid, const ReadOptions& options);

/// Cuts the grid at its header. `comma_delimits` as in NumberStyleVotes.
StemTable stem_table_from(Grid grid, std::size_t header_index, const std::string& file, bool comma_delimits);

}  // namespace stemwise
