#include "io/export_layer.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>

#include "io/crs.hpp"
#include "io/export_about.hpp"
#include "io/gdal_session.hpp"
#include "io/keep_layers.hpp"
#include "io/layer_text.hpp"
#include "io/memory_folder.hpp"
#include "io/replace_file.hpp"
#include "io/staged_files.hpp"
#include "io/write_layers.hpp"
#include "io/zip_file.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

/// How a suffix is written.
struct Format {
  std::string suffix;
  const char* driver;          ///< of GDAL; "" for our own text
  bool every_layer = false;    ///< holds several layers
  bool wgs84 = false;          ///< geometry must be longitude and latitude
  bool needs_geometry = false; ///< cannot hold a table without geometry
};

const std::vector<Format>& formats() {
  static const std::vector<Format> list = {{".gpkg", "GPKG", true},
                                           {".geojson", "GeoJSON", false, true},
                                           {".json", "GeoJSON", false, true},
                                           {".csv", ""},
                                           {".tsv", ""},
                                           {".txt", ""},
                                           {".shp", "ESRI Shapefile", false, false, true},
                                           {".fgb", "FlatGeobuf", false, false, true},
                                           {".kml", "KML", false, true, true},
                                           {".kmz", "KML", false, true, true},
                                           {".gpx", "GPX", false, true, true},
                                           {".dxf", "DXF", false, false, true},
                                           {".xlsx", "XLSX", true},
                                           {".ods", "ODS", true}};
  return list;
}

const Format* format_of(const std::string& path) {
  std::string suffix = fs::path(path).extension().string();
  for (char& c : suffix) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto it = std::find_if(formats().begin(), formats().end(), [&](const Format& f) { return f.suffix == suffix; });
  return it == formats().end() ? nullptr : &*it;
}

Result<Done> refused(const std::string& path, std::string text, std::string help) {
  return Result<Done>::failure(Issue{Severity::error, path, 0, {}, std::move(text), std::move(help)});
}

Result<Done> named(Issues issues, const std::string& path) {
  for (Issue& issue : issues) {
    if (issue.file.empty()) issue.file = path;
  }
  return Result<Done>::failure(std::move(issues));
}

/// GPX knows waypoints with a name, a height and a description only.
Layer waypoints(const Layer& layer) {
  Layer out = layer;
  out.name = "waypoints";
  out.columns = {{"name", ColumnType::text, 0, {}}, {"ele", ColumnType::real, 2, {}}, {"desc", ColumnType::text, 0, {}}};
  for (LayerFeature& f : out.features) {
    std::string description;
    LayerValue height;
    for (std::size_t i = 0; i < layer.columns.size(); ++i) {
      const std::string& column = layer.columns[i].name;
      if (column == "z") height = f.values[i];
      if (column != "dbh_cm" && column != "species" && column != "fate" && column != "note" && column != "inventory") continue;
      Layer cell;
      cell.columns = {layer.columns[i]};
      cell.features = {{{f.values[i]}, {}}};
      std::string text = layer_text(cell, {});
      text = text.substr(text.find('\n') + 1);
      text.pop_back();
      if (!text.empty()) description += (description.empty() ? "" : ", ") + column + " " + text;
    }
    const LayerValue name = f.values.front();
    f.values = {name, height, description};
    for (Eigen::Vector3d& corner : f.corners) corner.z() = std::numeric_limits<double>::quiet_NaN();  // the height has a column of its own
  }
  return out;
}

/// Puts the geometry of `from` on the rows of `layer`.
bool take_geometry(Layer& layer, const Layer& from) {
  if (layer.features.size() != from.features.size()) return false;
  for (std::size_t i = 0; i < layer.features.size(); ++i) layer.features[i].corners = from.features[i].corners;
  layer.epsg = from.epsg;
  return true;
}

/// Formats that need a place lose the rows that have none, and say so.
Issues leave_out_unplaced(Layer& layer, const Format& format) {
  const std::size_t lost = std::erase_if(layer.features, [](const LayerFeature& f) { return f.corners.empty(); });
  if (lost == 0) return {};
  return {{Severity::warning, {}, 0, {}, std::to_string(lost) + (lost == 1 ? " row has" : " rows have") + " no place on the map (surveys that were not aligned) and cannot stand in " + format.suffix,
           "export .csv, .xlsx or .gpkg"}};
}

Result<std::vector<Layer>> layers_for(const ProjectState& state, const Format& format, const ExportOptions& options) {
  using Layers = Result<std::vector<Layer>>;
  auto frame = EarthFrame::of(state.georeference, options.epsg);
  if (!frame) return Layers::failure(frame.issues);
  if (format.wgs84 && frame->is_local()) {
    return Layers::failure(Issue{Severity::error, {}, 0, {}, format.suffix + " needs a place on the earth and the project has no georeference",
                                 "give it an anchor, control points or a CRS (stemwise georeference), or export .gpkg or .csv in local coordinates"});
  }
  const Tables tables = derive_tables(state);
  std::vector<Layer> layers;
  if (!options.layer && format.every_layer) layers = project_layers(state, tables, *frame);
  else layers.push_back(project_layer(options.layer.value_or(LayerKind::trees), state, tables, *frame));
  if (format.wgs84 && *frame->epsg() != wgs84_epsg) {
    Georeference ellipsoidal = state.georeference;  // heights of these formats are above the ellipsoid (RFC 7946, section 4)
    ellipsoidal.geoid = {};
    const auto earth = EarthFrame::of(ellipsoidal, wgs84_epsg);
    if (!earth) return Layers::failure(earth.issues);
    const LayerKind kind = options.layer.value_or(LayerKind::trees);
    if (!take_geometry(layers.front(), project_layer(kind, state, tables, *earth))) {
      return Layers::failure(Issue{Severity::error, {}, 0, {}, "some rows have no place in the target system", {}});
    }
  }
  if (layers.front().geometry == LayerGeometry::none && format.needs_geometry && layers.size() == 1) {
    return Layers::failure(Issue{Severity::error, {}, 0, {}, "layer " + layers.front().name + " has no geometry and cannot be written as " + format.suffix,
                                 "export .csv, .xlsx or .gpkg"});
  }
  Issues issues;
  if (format.needs_geometry) issues = leave_out_unplaced(layers.front(), format);
  if (format.suffix == ".gpx") layers.front() = waypoints(layers.front());
  if (layers.size() > 1) {
    const Layer dictionary = data_dictionary(layers);
    layers.push_back(dictionary);
    layers.push_back(about_layer(state, *frame, options.software));
  }
  return Layers(std::move(layers), std::move(issues));
}

std::string date_of_stamp() { return timestamp_utc().substr(0, 10); }

LayerWriteOptions layer_options(const Format& format) {
  LayerWriteOptions o;
  const std::string_view driver = format.driver;
  o.spatial_index = driver == "GPKG";
  o.short_names = driver == "ESRI Shapefile";
  o.geometry_only = driver == "DXF";
  o.round_values = driver != "GPKG" && driver != "FlatGeobuf";
  if (driver == "GeoJSON") o.creation = {"RFC7946=YES", "COORDINATE_PRECISION=9", "SIGNIFICANT_FIGURES=15"};
  if (driver == "ESRI Shapefile") o.creation = {"ENCODING=UTF-8", "DBF_DATE_LAST_UPDATE=" + date_of_stamp()};
  return o;
}

/// Makes the data set at `target`; why it could not be, as issues.
Issues write_dataset(const Format& format, const std::vector<Layer>& layers, const std::string& target, GdalMessages& messages) {
  std::vector<std::string> creation;
  if (std::string_view(format.driver) == "KML") creation = {"NameField=tree_id"};
  DatasetPtr dataset = create_dataset(format.driver, target, creation);
  const auto failure = [&messages](const std::string& what) {
    return Issues{{Severity::error, {}, 0, {}, messages.errors().empty() ? what : messages.last_error(), ""}};
  };
  if (!dataset) return failure("the file cannot be made");
  const bool transaction = dataset->TestCapability(ODsCTransactions) != 0;
  if (transaction) dataset->StartTransaction();
  for (const Layer& layer : layers) {
    if (Issues issues = write_layer(*dataset, layer, layer_options(format)); !issues.empty()) return issues;
  }
  if (format.suffix == ".gpkg") {
    if (Issues issues = write_layer_styles("", *dataset); has_error(issues)) return issues;
  }
  if (transaction && dataset->CommitTransaction() != OGRERR_NONE) return failure("the file is not complete");
  dataset.reset();
  return messages.errors().empty() ? Issues{} : failure("the file is not complete");
}

/// Made in memory and written by ourselves. A Shapefile is several files.
Result<Done> stage_through_memory(const Format& format, std::vector<Layer> layers, const std::string& path, GdalMessages& messages, StagedFiles& staged) {
  const MemoryFolder folder;
  if (format.suffix == ".shp") layers.front().name = fs::path(path).stem().string();
  const std::string name = format.suffix == ".kmz" ? "doc.kml" : fs::path(path).filename().string();
  if (Issues issues = write_dataset(format, layers, folder.path_of(name), messages); !issues.empty()) return Result<Done>::failure(cannot_write(path, issues.front().text));
  if (format.suffix == ".kmz") {
    staged.adopt(path);
    return write_temporary_zip(path, {{name, folder.bytes_of(name)}});
  }
  Result<Done> done = Done{};
  for (const std::string& file : folder.names())
    if (done) done = staged.add((fs::path(path).parent_path() / file).string(), folder.bytes_of(file));
  return done;
}

}  // namespace

const std::vector<std::string>& export_suffixes() {
  static const std::vector<std::string> suffixes = [] {
    std::vector<std::string> list;
    for (const Format& f : formats()) list.push_back(f.suffix);
    return list;
  }();
  return suffixes;
}

namespace {

Result<Done> stage_layers(const Format& format, const std::vector<Layer>& layers, const std::string& path, const ExportOptions& options, StagedFiles& staged) {
  if (std::string_view(format.driver).empty()) {
    TextTableStyle style;
    style.decimal_comma = options.decimal_comma;
    style.delimiter = options.delimiter.value_or(format.suffix == ".tsv" ? '\t' : options.decimal_comma ? ';' : ',');
    return staged.add(path, (options.decimal_comma ? "\xEF\xBB\xBF" : "") + layer_text(layers.front(), style));
  }
  GdalMessages messages;
  const GdalOption stamp("OGR_CURRENT_DATE", timestamp_utc_ms());
  const GdalOption no_sync("OGR_SQLITE_SYNCHRONOUS", "OFF");
  if (format.suffix != ".gpkg") return stage_through_memory(format, layers, path, messages, staged);
  const std::string temporary = temporary_beside(path);
  std::error_code ignored;
  fs::remove(temporary, ignored);
  staged.adopt(path);
  Issues issues = write_dataset(format, layers, temporary, messages);
  fs::remove(temporary + "-journal", ignored);
  return issues.empty() ? Result<Done>(Done{}) : Result<Done>::failure(cannot_write(path, issues.front().text));
}

}  // namespace

Result<Done> export_layer(const ProjectState& state, const std::string& path, const ExportOptions& options) {
  const Format* format = format_of(path);
  if (format == nullptr) {
    std::string all;
    for (const std::string& suffix : export_suffixes()) all += (all.empty() ? "" : ", ") + suffix;
    return refused(path, "the suffix names no format that can be written", "choose one of " + all);
  }
  auto layers = layers_for(state, *format, options);
  if (!layers) return named(std::move(layers.issues), path);
  StagedFiles staged;
  if (Result<Done> done = stage_layers(*format, *layers.value, path, options, staged); !done) return done;
  if (layers->size() == 1) {
    const auto frame = EarthFrame::of(state.georeference, options.epsg);
    Result<Done> done = staged.add(path + ".about.txt", about_text(state, *frame, options.software, layers->front(), format->suffix == ".shp"));
    if (!done) return done;
  }
  Result<Done> done = staged.put_in_place();
  for (Issue& issue : layers.issues) issue.file = path;
  if (done) done.issues = std::move(layers.issues);
  return done;
}

}  // namespace stemwise
