#pragma once
#include <string>

#include "io/stem_table.hpp"

namespace stemwise {

/// What a file is by its first bytes.
enum class FileKind { text, workbook, sqlite, gis, unknown_binary };
FileKind file_kind(const std::string& path);

/// Opens GIS points (GeoPackage, Shapefile, GeoJSON, FlatGeobuf, KML, GPX) through GDAL: positions from the geometry, the
/// coordinate system from the file, the rest from the attributes.
Result<OpenedTable> open_gis_points(const std::string& path, const ReadOptions& options = {});

/// Opens a sheet of a workbook (XLSX, ODS, XLS): the one named, else the one that looks most like a stem table.
Result<OpenedTable> open_workbook(const std::string& path, const ReadOptions& options = {});

}  // namespace stemwise
