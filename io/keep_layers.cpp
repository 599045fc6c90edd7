#include "io/keep_layers.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "io/layer_style.hpp"
#include "io/project_layers.hpp"
#include "io/replace_file.hpp"

namespace stemwise {
namespace {

constexpr const char* styles_table = "layer_styles";
constexpr const char* our_style = "Stemwise";

bool is_ours(const std::string& name) {
  for (std::size_t i = 0; i < layer_kind_count; ++i)
    if (name == to_string(static_cast<LayerKind>(i))) return true;
  return name.starts_with("stemwise_") || name == styles_table;
}

/// SQLite's and GeoPackage's own tables, and what belongs to a spatial index.
bool is_machinery(const std::string& name) { return name.starts_with("gpkg_") || name.starts_with("rtree_") || name.starts_with("sqlite_") || name == "ogr_empty_table"; }

DatasetPtr open_all_tables(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return nullptr;
  const char* const options[] = {"LIST_ALL_TABLES=YES", nullptr};
  return DatasetPtr(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, options, nullptr));
}

bool is_registered(GDALDataset& dataset, const std::string& name) {
  OGRLayer* rows = dataset.ExecuteSQL(("SELECT count(*) FROM gpkg_contents WHERE table_name = '" + name + "'").c_str(), nullptr, nullptr);
  if (rows == nullptr) return true;
  const FeaturePtr row(rows->GetNextFeature());
  const bool found = row && row->GetFieldAsInteger(0) > 0;
  dataset.ReleaseResultSet(rows);
  return found;
}

bool copy_layer(GDALDataset& from, OGRLayer& layer, GDALDataset& into) {
  std::vector<std::string> options;
  if (*layer.GetFIDColumn() != 0) options.push_back(std::string("FID=") + layer.GetFIDColumn());
  if (layer.GetGeomType() != wkbNone && *layer.GetGeometryColumn() != 0) options.push_back(std::string("GEOMETRY_NAME=") + layer.GetGeometryColumn());
  for (const char* key : {"IDENTIFIER", "DESCRIPTION"})
    if (const char* value = layer.GetMetadataItem(key)) options.push_back(std::string(key) + "=" + value);
  if (layer.GetGeomType() == wkbNone && !is_registered(from, layer.GetName())) options.emplace_back("ASPATIAL_VARIANT=NOT_REGISTERED");
  char** list = nullptr;
  for (const std::string& option : options) list = CSLAddString(list, option.c_str());
  const GIntBig rows = layer.GetFeatureCount();
  OGRLayer* copy = into.CopyLayer(&layer, layer.GetName(), list);
  CSLDestroy(list);
  return copy != nullptr && copy->GetFeatureCount() == rows;
}

constexpr std::array style_columns = {"f_table_catalog", "f_table_schema", "f_table_name", "f_geometry_column", "styleName", "styleQML",
                                      "styleSLD",        "useAsDefault",   "description",  "owner",             "ui",        "update_time"};

struct StyleRow {
  std::array<std::string, style_columns.size()> cells;
  std::string& operator[](std::size_t i) { return cells[i]; }
};
constexpr std::size_t table_cell = 2, geometry_cell = 3, name_cell = 4, qml_cell = 5, default_cell = 7, description_cell = 8, owner_cell = 9, time_cell = 11;

std::vector<StyleRow> saved_by_people(const std::string& old_path) {
  const DatasetPtr old = open_all_tables(old_path);
  OGRLayer* table = old ? old->GetLayerByName(styles_table) : nullptr;
  std::vector<StyleRow> rows;
  if (table == nullptr) return rows;
  for (FeaturePtr feature(table->GetNextFeature()); feature; feature.reset(table->GetNextFeature())) {
    StyleRow row;
    for (std::size_t i = 0; i < style_columns.size(); ++i) {
      const int at = feature->GetFieldIndex(style_columns[i]);
      if (at >= 0 && feature->IsFieldSetAndNotNull(at)) row[i] = feature->GetFieldAsString(at);
    }
    if (row[owner_cell] != our_style) rows.push_back(std::move(row));
  }
  return rows;
}

OGRLayer* make_styles_table(GDALDataset& into) {
  const char* const options[] = {"FID=id", "ASPATIAL_VARIANT=NOT_REGISTERED", nullptr};
  OGRLayer* table = into.CreateLayer(styles_table, nullptr, wkbNone, const_cast<char**>(options));
  if (table == nullptr) return nullptr;
  for (std::size_t i = 0; i < style_columns.size(); ++i) {
    OGRFieldDefn field(style_columns[i], i == default_cell ? OFTInteger : i == time_cell ? OFTDateTime : OFTString);
    if (i == default_cell) field.SetSubType(OFSTBoolean);
    if (table->CreateField(&field) != OGRERR_NONE) return nullptr;
  }
  return table;
}

Issue not_kept(const std::string& name) {
  return {Severity::warning, "", 0, "", "the layer " + name + " of the old file could not be taken over", CPLGetLastErrorMsg()};
}

}  // namespace

Issues keep_foreign_layers(const std::string& old_path, GDALDataset& into) {
  const DatasetPtr old = open_all_tables(old_path);
  if (!old || old->GetLayerByName("stemwise_project") == nullptr) return {};
  Issues issues;
  for (int i = 0; i < old->GetLayerCount(); ++i) {
    OGRLayer* layer = old->GetLayer(i);
    if (is_ours(layer->GetName()) || is_machinery(layer->GetName())) continue;
    if (!copy_layer(*old, *layer, into)) issues.push_back(not_kept(layer->GetName()));
  }
  return issues;
}

Issues write_layer_styles(const std::string& old_path, GDALDataset& into) {
  std::vector<StyleRow> rows = saved_by_people(old_path);
  for (std::size_t i = 0; i < layer_kind_count; ++i) {
    const auto kind = static_cast<LayerKind>(i);
    OGRLayer* layer = into.GetLayerByName(to_string(kind));
    const std::string qml = layer == nullptr ? "" : layer_qml(kind, *layer);
    if (qml.empty()) continue;
    const bool is_taken = std::any_of(rows.begin(), rows.end(), [&](const StyleRow& r) { return r.cells[table_cell] == to_string(kind) && r.cells[default_cell] == "1"; });
    StyleRow row;
    row[table_cell] = to_string(kind);
    row[geometry_cell] = layer->GetGeometryColumn();
    row[name_cell] = our_style;
    row[qml_cell] = qml;
    row[default_cell] = is_taken ? "0" : "1";
    row[description_cell] = "as Stemwise draws it";
    row[owner_cell] = our_style;
    row[time_cell] = timestamp_utc();
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return {};
  OGRLayer* table = make_styles_table(into);
  if (table == nullptr) return {not_kept(styles_table)};
  for (StyleRow& row : rows) {
    OGRFeature feature(table->GetLayerDefn());
    for (std::size_t i = 0; i < style_columns.size(); ++i) {
      if (i == default_cell) feature.SetField(static_cast<int>(i), row[i] == "1" ? 1 : 0);
      else if (i != time_cell || !row[i].empty()) feature.SetField(static_cast<int>(i), row[i].c_str());
    }
    if (table->CreateFeature(&feature) != OGRERR_NONE) return {not_kept(styles_table)};
  }
  return {};
}

}  // namespace stemwise
