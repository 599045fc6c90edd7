#pragma once
#include <string>

#include "app/session.hpp"

namespace stemwise {

struct ExportCommandOptions {
  std::string project;
  std::string output;
  std::string layer;      ///< empty: trees, or every layer for GeoPackage and workbooks
  std::string crs;        ///< EPSG:N; empty: that of the georeference
  std::string delimiter;  ///< one character, or "tab"
  bool decimal_comma = false;
};

/// `stemwise export PROJECT -o FILE`: layers of the project, format by suffix.
ExitCode run_export(const ExportCommandOptions& options, Session& session);

}  // namespace stemwise
