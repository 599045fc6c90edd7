#pragma once
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace stemwise {

/// One inventory of a batch's manifest.
struct ManifestRow {
  std::int64_t row = 0;
  std::string path;       ///< as it stands there, made absolute from the manifest's folder
  std::string name;       ///< empty: from the path
  std::string date;       ///< empty: from the file
  bool is_reference = false;
};

/// One plot: its rows in the order of the file.
struct ManifestPlot {
  std::string plot;
  std::vector<ManifestRow> rows;
};

/// Reads `plot,path` and optionally `name,date,reference` (cli.md, "batch"); plots in the order of their first row. Rows
/// without a plot or a path are warnings; a failure when none is usable or a plot's name cannot be a folder's.
Result<std::vector<ManifestPlot>> read_manifest(const std::string& path);

}  // namespace stemwise
