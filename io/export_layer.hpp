#pragma once
#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/project/project_state.hpp"
#include "io/project_layers.hpp"

namespace stemwise {

struct ExportOptions {
  std::optional<LayerKind> layer;  ///< none: trees; every layer for GeoPackage and workbooks
  std::optional<int> epsg;         ///< none: that of the georeference (UTM zone of its origin); local without one
  std::optional<char> delimiter;   ///< of CSV; none: comma, or semicolon with a decimal comma
  bool decimal_comma = false;      ///< of CSV; also a byte order mark, so that Excel reads UTF-8
  std::string software = "Stemwise";  ///< with its version
};

/// Suffixes that can be written, ".gpkg", ".geojson", ... for file dialogs.
const std::vector<std::string>& export_suffixes();

/// Writes layers of the project (columns of cli.md), the format by the suffix of `path`: gpkg, geojson, csv, tsv, shp, fgb, kml,
/// kmz, gpx, dxf, xlsx, ods. A file of one layer gets "<file>.about.txt" beside it: software, CRS, units, settings, seed, alignment
/// quality, and what every column means (with a Shapefile's short names); GeoPackages and workbooks have that inside. Geometry of GeoJSON, KML and GPX is WGS 84, their x and y columns are in the target system. A
/// format that needs a place on the earth is refused without a georeference. The file is replaced only by a complete one.
Result<Done> export_layer(const ProjectState& state, const std::string& path, const ExportOptions& options = {});

}  // namespace stemwise
