#include "io/write_layers.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "io/crs.hpp"

namespace stemwise {
namespace {

char** string_list(const std::vector<std::string>& options) {
  char** list = nullptr;
  for (const std::string& option : options) list = CSLAddString(list, option.c_str());
  return list;
}

/// Every corner has a height; otherwise the layer is flat, and what is known of heights stands in its columns.
bool is_3d(const Layer& layer) {
  if (layer.features.empty()) return false;
  return std::all_of(layer.features.begin(), layer.features.end(), [](const LayerFeature& f) {
    return std::all_of(f.corners.begin(), f.corners.end(), [](const Eigen::Vector3d& c) { return std::isfinite(c.z()); });
  });
}

OGRwkbGeometryType geometry_type(LayerGeometry geometry, bool with_z) {
  switch (geometry) {
    case LayerGeometry::none: return wkbNone;
    case LayerGeometry::point: return with_z ? wkbPoint25D : wkbPoint;
    case LayerGeometry::line: return wkbLineString;
    case LayerGeometry::polygon: return wkbPolygon;
  }
  return wkbNone;
}

std::unique_ptr<OGRGeometry> geometry_of(const Layer& layer, const LayerFeature& feature, bool with_z) {
  const auto& corners = feature.corners;
  if (corners.empty() || layer.geometry == LayerGeometry::none) return nullptr;
  if (layer.geometry == LayerGeometry::point) {
    if (with_z) return std::make_unique<OGRPoint>(corners[0].x(), corners[0].y(), corners[0].z());
    return std::make_unique<OGRPoint>(corners[0].x(), corners[0].y());
  }
  if (layer.geometry == LayerGeometry::line) {
    auto line = std::make_unique<OGRLineString>();
    for (const auto& c : corners) line->addPoint(c.x(), c.y());
    return line;
  }
  auto ring = std::make_unique<OGRLinearRing>();
  for (const auto& c : corners) ring->addPoint(c.x(), c.y());
  ring->closeRings();
  auto polygon = std::make_unique<OGRPolygon>();
  polygon->addRingDirectly(ring.release());
  return polygon;
}

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

void set_value(OGRFeature& feature, int i, const LayerValue& value, const LayerColumn& column, bool round) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) feature.SetField(i, static_cast<GIntBig>(*whole));
  else if (const auto* number = std::get_if<double>(&value)) feature.SetField(i, round ? rounded(*number, column.decimals) : *number);
  else if (const auto* text = std::get_if<std::string>(&value)) feature.SetField(i, text->c_str());
  else feature.SetFieldNull(i);
}

OGRSpatialReference system_for(const Layer& layer) {
  OGRSpatialReference system;
  if (layer.epsg) system.importFromEPSG(*layer.epsg);
  else system.SetLocalCS("Undefined Cartesian SRS"), system.SetLinearUnits("metre", 1.0);
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return system;
}

Issue failed(const Layer& layer, const std::string& what) {
  return {Severity::error, {}, 0, {}, "layer " + layer.name + ": " + what + ": " + CPLGetLastErrorMsg(), {}};
}

/// A field per column; `fields`: the index of each. GPX and KML have some of their own from the start.
Issues add_fields(OGRLayer& target, const Layer& layer, const LayerWriteOptions& options, std::vector<int>& fields) {
  const int own = target.GetLayerDefn()->GetFieldCount();
  const std::vector<std::string> short_names = options.short_names ? short_column_names(layer.columns) : std::vector<std::string>();
  for (std::size_t i = 0; i < layer.columns.size(); ++i) {
    const LayerColumn& column = layer.columns[i];
    const OGRFieldType type = column.type == ColumnType::integer ? OFTInteger64 : column.type == ColumnType::real ? OFTReal : OFTString;
    OGRFieldDefn field(options.short_names ? short_names[i].c_str() : column.name.c_str(), type);
    if (options.short_names && column.type == ColumnType::real) field.SetWidth(24), field.SetPrecision(column.decimals);
    if (options.short_names && column.type == ColumnType::integer) field.SetWidth(10);
    const int there = target.GetLayerDefn()->GetFieldIndex(field.GetNameRef());
    fields.push_back(there >= 0 && there < own ? there : target.GetLayerDefn()->GetFieldCount());
    if (fields.back() != there && target.CreateField(&field) != OGRERR_NONE) return {failed(layer, "column " + column.name)};
  }
  return {};
}

}  // namespace

DatasetPtr create_dataset(const char* driver_name, const std::string& path, const std::vector<std::string>& options) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  if (driver == nullptr) return nullptr;
  char** list = string_list(options);
  DatasetPtr dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, list));
  CSLDestroy(list);
  return dataset;
}

Issues write_layer(GDALDataset& dataset, const Layer& layer, const LayerWriteOptions& options) {
  std::vector<std::string> creation = options.creation;
  const bool geopackage = std::string_view(dataset.GetDriverName()) == "GPKG";
  if (geopackage) {
    creation.push_back("IDENTIFIER=" + layer.title);
    if (layer.geometry != LayerGeometry::none && !options.spatial_index) creation.emplace_back("SPATIAL_INDEX=NO");
  }
  OGRSpatialReference system = system_for(layer);
  const bool needs_system = layer.geometry != LayerGeometry::none && (layer.epsg || geopackage);
  const bool with_z = is_3d(layer);
  char** list = string_list(creation);
  OGRLayer* target = dataset.CreateLayer(layer.name.c_str(), needs_system ? &system : nullptr, geometry_type(layer.geometry, with_z), list);
  CSLDestroy(list);
  if (target == nullptr) return {failed(layer, "cannot be made")};
  std::vector<int> fields;
  if (!options.geometry_only) {
    if (Issues issues = add_fields(*target, layer, options, fields); !issues.empty()) return issues;
  }
  OGRFeature feature(target->GetLayerDefn());
  for (const LayerFeature& row : layer.features) {
    feature.Reset();
    for (std::size_t i = 0; i < row.values.size() && !options.geometry_only; ++i) {
      set_value(feature, fields[i], row.values[i], layer.columns[i], options.round_values);
    }
    feature.SetGeometryDirectly(geometry_of(layer, row, with_z).release());
    if (target->CreateFeature(&feature) != OGRERR_NONE) return {failed(layer, "a row cannot be written")};
  }
  return {};
}

std::vector<std::string> short_column_names(const std::vector<LayerColumn>& columns) {
  static const std::map<std::string, std::string> known = {{"position_sd_m", "pos_sd_m"},   {"first_seen", "first_seen"}, {"times_seen", "times_seen"},
                                                           {"growth_cm_per_year", "grow_cm_yr"}, {"inventory_a", "inv_a"}, {"inventory_b", "inv_b"},
                                                           {"source_id_a", "src_id_a"},     {"source_id_b", "src_id_b"},  {"dbh_change_cm", "dbh_chg_cm"},
                                                           {"change_class", "chg_class"},   {"dbh_error_cm", "dbh_err_cm"}};
  std::vector<std::string> names;
  for (const LayerColumn& column : columns) {
    const auto it = known.find(column.name);
    std::string name = it != known.end() ? it->second : column.name;
    if (name.size() > 10) name = name.starts_with("dbh_") ? "d_" + name.substr(name.size() - 3 - std::min<std::size_t>(8, name.size() - 7), 8) : name.substr(0, 10);
    for (int n = 2; std::find(names.begin(), names.end(), name) != names.end(); ++n) name = name.substr(0, 8) + "_" + std::to_string(n);
    names.push_back(name);
  }
  return names;
}

}  // namespace stemwise
