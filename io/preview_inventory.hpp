#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/read_inventory.hpp"

namespace stemwise {

/// One column that is read: what it means, where it is, in which unit and why.
struct ColumnPreview {
  std::string kind;      ///< our name of it: "dbh"
  std::string header;    ///< the file's
  std::string unit;      ///< empty where it has none
  std::string how;       ///< "by header", "as told", "median 31.5"
  bool guessed = false;  ///< the unit was guessed from the values or the layout
};

struct StatusCodePreview {
  std::string code;
  std::int64_t rows = 0;
  StemStatus meaning = StemStatus::unknown;
};

/// A file as it would be read, with what a person needs to see in order to correct that.
struct InventoryPreview {
  std::string path;
  std::string format;                            ///< "table", "workbook (XLSX)", "frame folder", ...; empty: not recognised
  std::vector<std::string> sheets;               ///< of a workbook, layers of a GIS file
  std::string sheet;                             ///< the one that was opened
  std::vector<std::string> header;               ///< empty where there is no table
  std::vector<std::int64_t> row_numbers;         ///< of `rows`
  std::vector<std::vector<std::string>> rows;    ///< the first ones, as the file has them
  std::int64_t row_count = 0;                    ///< of all
  std::vector<ColumnPreview> columns;
  std::vector<StatusCodePreview> status_codes;   ///< those met: those that say nothing to us first, then the most frequent
  std::vector<std::string> plot_columns;         ///< headers of columns that may tell plots apart
  std::string plot_column;                       ///< the one that `plots` are of
  std::vector<std::string> plots;
  Result<Inventory> inventory;                   ///< exactly what read_inventory gives
};

/// Reads the inventory with `options`, as read_inventory does, and tells how. A text file in which no header is recognised
/// shows its first line as the header: naming columns of it in the options makes it readable.
InventoryPreview preview_inventory(const std::string& path, const ReadOptions& options = {});

}  // namespace stemwise
