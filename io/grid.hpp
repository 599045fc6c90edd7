#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace stemwise {

/// One row of a table as text. `row` is the line of the file, or the row of the sheet, as an editor shows it.
struct GridRow {
  std::int64_t row = 0;
  std::vector<std::string> cells;
};

/// A table before anyone knows what its columns mean: cells of UTF-8 text, trimmed, rows without any text left out.
struct Grid {
  std::vector<GridRow> rows;
};

}  // namespace stemwise
