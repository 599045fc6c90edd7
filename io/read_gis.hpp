#pragma once
#include <string>

#include "core/base/result.hpp"
#include "core/forest/inventory.hpp"
#include "io/read_inventory.hpp"

namespace stemwise {

/// What a file is by its first bytes.
enum class FileKind { text, workbook, sqlite, gis, unknown_binary };
FileKind file_kind(const std::string& path);

/// Reads GIS points (GeoPackage, Shapefile, GeoJSON, FlatGeobuf, KML, GPX) through GDAL: positions from the geometry, the
/// coordinate system from the file (geographic ones are projected to UTM), the rest from the attributes.
Result<Inventory> read_gis_points(const std::string& path, const ReadOptions& options = {});

/// Reads a sheet of a workbook (XLSX, ODS, XLS): the one named, else the one that looks most like a stem table.
Result<Inventory> read_workbook(const std::string& path, const ReadOptions& options = {});

}  // namespace stemwise
