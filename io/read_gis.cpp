#include "io/read_gis.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>

#include "io/crs.hpp"
#include "io/delimited_text.hpp"
#include "io/exact_number.hpp"
#include "io/gdal_dataset.hpp"
#include "io/gdal_session.hpp"
#include "io/stem_table.hpp"
#include "io/text_file.hpp"

namespace stemwise {
namespace {

Result<OpenedTable> refused(const std::string& path, std::string text, std::string help) {
  return Result<OpenedTable>::failure(Issue{Severity::error, path, 0, {}, std::move(text), std::move(help)});
}

std::string field_text(const OGRFeature& feature, int field) {
  if (!feature.IsFieldSetAndNotNull(field)) return {};
  if (feature.GetFieldDefnRef(field)->GetType() == OFTReal) return exact_text(feature.GetFieldAsDouble(field));
  std::string text(trimmed(const_cast<OGRFeature&>(feature).GetFieldAsString(field)));
  return is_valid_utf8(text) ? text : utf8_from_windows_1252(text);
}

std::vector<std::string> layer_list(GDALDataset& dataset) {
  std::vector<std::string> names;
  for (OGRLayer* layer : dataset.GetLayers()) names.emplace_back(layer->GetName());
  return names;
}

std::string layer_names(GDALDataset& dataset) {
  std::string names;
  for (const std::string& name : layer_list(dataset)) names += (names.empty() ? "" : ", ") + name;
  return names;
}

/// Header and rows of a layer's attributes.
Grid attribute_grid(OGRLayer& layer, bool with_header) {
  Grid grid;
  OGRFeatureDefn* definition = layer.GetLayerDefn();
  if (with_header) {
    GridRow header;
    for (int i = 0; i < definition->GetFieldCount(); ++i) header.cells.emplace_back(trimmed(definition->GetFieldDefn(i)->GetNameRef()));
    grid.rows.push_back(std::move(header));
  }
  layer.ResetReading();
  std::int64_t count = 0;
  while (FeaturePtr feature{layer.GetNextFeature()}) {
    ++count;
    GridRow row{with_header || feature->GetFID() <= 0 ? count : feature->GetFID(), {}};
    bool any = with_header;
    for (int i = 0; i < definition->GetFieldCount(); ++i) {
      row.cells.push_back(field_text(*feature, i));
      any = any || !row.cells.back().empty();
    }
    if (any) grid.rows.push_back(std::move(row));
  }
  return grid;
}

/// The file's system as an EPSG code whose unit is the metre, or WGS 84 with `to_wgs84` to get there.
struct LayerSystem {
  std::optional<int> epsg;
  std::unique_ptr<OGRCoordinateTransformation> to_wgs84;
};

std::optional<int> epsg_code(const OGRSpatialReference& system) {
  const auto code_of = [](const OGRSpatialReference& s) -> std::optional<int> {
    const char* authority = s.GetAuthorityName(nullptr);
    const char* code = s.GetAuthorityCode(nullptr);
    if (authority == nullptr || code == nullptr || std::string(authority) != "EPSG") return std::nullopt;
    return std::atoi(code);
  };
  if (const auto code = code_of(system)) return code;
  OGRSpatialReference identified(system);
  if (identified.AutoIdentifyEPSG() == OGRERR_NONE) return code_of(identified);
  return std::nullopt;
}

LayerSystem system_of(OGRLayer& layer) {
  LayerSystem out;
  const OGRSpatialReference* given = layer.GetSpatialRef();
  if (given == nullptr || given->IsLocal() || !(given->IsProjected() || given->IsGeographic())) return out;
  OGRSpatialReference system(*given);
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const auto code = epsg_code(system);
  if (system.IsProjected() && code && std::abs(system.GetLinearUnits() - 1.0) < 1e-9) {
    out.epsg = code;
    return out;
  }
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(wgs84_epsg);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  out.epsg = wgs84_epsg;
  out.to_wgs84.reset(OGRCreateCoordinateTransformation(&system, &wgs84));
  return out;
}

/// Adds geometry_x, geometry_y and, for 3D layers, geometry_z in front of the attributes.
void add_geometry(OGRLayer& layer, LayerSystem& system, Grid& grid) {
  const bool has_z = OGR_GT_HasZ(layer.GetGeomType()) != 0;
  std::vector<std::string> names = {"geometry_x", "geometry_y"};
  if (has_z) names.emplace_back("geometry_z");
  grid.rows[0].cells.insert(grid.rows[0].cells.begin(), names.begin(), names.end());
  layer.ResetReading();
  std::size_t at = 1;
  while (FeaturePtr feature{layer.GetNextFeature()}) {
    std::vector<std::string> cells(names.size());
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry != nullptr && wkbFlatten(geometry->getGeometryType()) == wkbMultiPoint && geometry->toMultiPoint()->getNumGeometries() > 0) {
      geometry = geometry->toMultiPoint()->getGeometryRef(0);
    }
    if (geometry != nullptr && wkbFlatten(geometry->getGeometryType()) == wkbPoint && !geometry->IsEmpty()) {
      const OGRPoint* point = geometry->toPoint();
      double x = point->getX();
      double y = point->getY();
      if (!system.to_wgs84 || system.to_wgs84->Transform(1, &x, &y)) {
        cells[0] = exact_text(x);
        cells[1] = exact_text(y);
        if (has_z) cells[2] = exact_text(point->getZ());
      }
    }
    auto& row = grid.rows[at++].cells;
    row.insert(row.begin(), cells.begin(), cells.end());
  }
}

bool holds_points(OGRLayer& layer) {
  const auto type = wkbFlatten(layer.GetGeomType());
  if (type == wkbPoint || type == wkbMultiPoint) return true;
  if (type != wkbUnknown) return false;
  layer.ResetReading();
  const FeaturePtr first(layer.GetNextFeature());
  layer.ResetReading();
  return first && first->GetGeometryRef() != nullptr && wkbFlatten(first->GetGeometryRef()->getGeometryType()) == wkbPoint;
}

Issue several(const std::string& path, const char* what, const std::string& names, const std::string& chosen) {
  return {Severity::warning, path, 0, {}, std::string("holds several ") + what + " with trees (" + names + "); " + chosen + " was read",
          "choose another with --sheet NAME"};
}

struct Sheet {
  std::string name;
  Grid grid;
  std::size_t header = 0;
  int score = 0;
};

/// The sheets that look like stem tables, best first.
std::vector<Sheet> stem_sheets(GDALDataset& dataset, const ReadOptions& options) {
  std::vector<Sheet> sheets;
  for (OGRLayer* layer : dataset.GetLayers()) {
    if (!options.sheet.empty() && options.sheet != layer->GetName()) continue;
    Sheet sheet{layer->GetName(), attribute_grid(*layer, false), 0, 0};
    const auto header = find_header(sheet.grid, options);
    if (!header) continue;
    sheet.header = *header;
    sheet.score = header_score(sheet.grid.rows[*header], options);
    sheets.push_back(std::move(sheet));
  }
  std::stable_sort(sheets.begin(), sheets.end(), [](const Sheet& a, const Sheet& b) { return a.score > b.score; });
  return sheets;
}

}  // namespace

FileKind file_kind(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(512, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  if (head.starts_with("SQLite format 3")) return FileKind::sqlite;
  if (head.starts_with("PK\x03\x04") || head.starts_with("\xD0\xCF\x11\xE0")) return FileKind::workbook;
  if (head.starts_with("fgb\x03") || head.starts_with(std::string_view("\0\0\x27\x0A", 4))) return FileKind::gis;
  std::string_view text = trimmed(head.starts_with("\xEF\xBB\xBF") ? std::string_view(head).substr(3) : std::string_view(head));
  if (text.starts_with('{') || text.starts_with("<?xml") || text.starts_with("<kml") || text.starts_with("<gpx")) return FileKind::gis;
  const bool utf16 = head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF");
  if (!utf16 && head.find('\0') != std::string::npos) return FileKind::unknown_binary;
  return FileKind::text;
}

Result<OpenedTable> open_gis_points(const std::string& path, const ReadOptions& options) {
  const GdalMessages messages;
  const DatasetPtr dataset = open_vector(path);
  if (!dataset) return refused(path, "cannot be opened as GIS data: " + messages.last_error(), "save it as GeoPackage, Shapefile, GeoJSON or CSV");
  std::vector<OGRLayer*> layers;
  std::string names;
  for (OGRLayer* layer : dataset->GetLayers()) {
    if (!options.sheet.empty() ? options.sheet != layer->GetName() : !holds_points(*layer)) continue;
    layers.push_back(layer);
    names += (names.empty() ? "" : ", ") + std::string(layer->GetName());
  }
  if (layers.empty()) {
    return refused(path, (options.sheet.empty() ? std::string("has no layer of points") : "has no layer " + options.sheet) + "; its layers: " + layer_names(*dataset),
                   "stems must be points");
  }
  OGRLayer& layer = *layers.front();
  LayerSystem system = system_of(layer);
  Grid grid = attribute_grid(layer, true);
  add_geometry(layer, system, grid);
  StemTable table = stem_table_from(std::move(grid), 0, path, true);
  table.notes.push_back("layer: " + std::string(layer.GetName()));
  table.notes.push_back(system.epsg ? "coordinate system: " + crs_name(*system.epsg) + " (EPSG:" + std::to_string(*system.epsg) + ")" : "coordinate system: none");
  if (layers.size() > 1) table.issues.push_back(several(path, "layers", names, layer.GetName()));
  return OpenedTable{std::move(table), system.epsg, std::string("GIS points (") + dataset->GetDriverName() + ")", layer_list(*dataset)};
}

Result<OpenedTable> open_workbook(const std::string& path, const ReadOptions& options) {
  const GdalMessages messages;
  const GdalOption no_header_x("OGR_XLSX_HEADERS", "DISABLE"), strings_x("OGR_XLSX_FIELD_TYPES", "STRING");
  const GdalOption no_header_o("OGR_ODS_HEADERS", "DISABLE"), strings_o("OGR_ODS_FIELD_TYPES", "STRING");
  const GdalOption no_header_s("OGR_XLS_HEADERS", "DISABLE"), strings_s("OGR_XLS_FIELD_TYPES", "STRING");
  const DatasetPtr dataset = open_vector(path);
  if (!dataset) return refused(path, "cannot be opened as a workbook: " + messages.last_error(), "save the sheet as CSV");
  std::vector<Sheet> sheets = stem_sheets(*dataset, options);
  if (sheets.empty()) {
    return refused(path, "no sheet holds a stem table; its sheets: " + layer_names(*dataset), "expected a row with column names such as x, y, dbh; choose with --sheet NAME");
  }
  std::string names;
  std::size_t equals = 0;
  for (const Sheet& s : sheets) {
    if (s.score < sheets.front().score) continue;
    ++equals;
    names += (names.empty() ? "" : ", ") + s.name;
  }
  const std::string chosen = sheets.front().name;
  StemTable table = stem_table_from(std::move(sheets.front().grid), sheets.front().header, path, true);
  table.notes.insert(table.notes.begin(), "sheet: " + chosen);
  if (equals > 1) table.issues.push_back(several(path, "sheets", names, chosen));
  return OpenedTable{std::move(table), std::nullopt, std::string("workbook (") + dataset->GetDriverName() + ")", layer_list(*dataset)};
}

}  // namespace stemwise
