#include "ui/panels/export_form_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "ui/text/format.hpp"
#include "ui/text/georeference_words.hpp"

namespace stemwise::ui {
namespace {

struct Format {
  const char* label;
  const char* suffix;
  bool on_earth;  ///< has no meaning without a georeference
};
constexpr Format formats[] = {{"GeoPackage (.gpkg)", ".gpkg", false}, {"CSV table (.csv)", ".csv", false},     {"Workbook (.xlsx)", ".xlsx", false},
                              {"OpenDocument (.ods)", ".ods", false}, {"GeoJSON (.geojson)", ".geojson", true}, {"Shapefile (.shp)", ".shp", false},
                              {"KML (.kml)", ".kml", true},           {"KMZ (.kmz)", ".kmz", true},             {"GPX waypoints (.gpx)", ".gpx", true},
                              {"DXF drawing (.dxf)", ".dxf", false},  {"FlatGeobuf (.fgb)", ".fgb", false},     {"Tab-separated (.tsv)", ".tsv", false}};

struct Layer {
  const char* label;
  const char* word;
  const char* help;
};
constexpr Layer layers[] = {
    {"Trees (merged inventory)", "trees", "One row per tree: merged position, DBH with its source, fate, growth."},
    {"Observations", "observations", "One row per stem of every survey."},
    {"Matches", "matches", "One row per tree and pair of consecutive sightings."},
    {"Links", "links", "The matches as lines."},
    {"Inventories", "inventories", "One row per survey with its alignment."},
    {"Coverage", "coverage", "Where each survey looked, as polygons."},
    {"ForestGEO census table", "forestgeo", "One row per stem and census, with the columns of ForestGEO's R tables."},
};
constexpr std::size_t first_values = 12;

}  // namespace

std::string ExportFormPanel::suffix() const { return formats[format_].suffix; }

void ExportFormPanel::propose_path(const std::string& folder, const std::string& title) {
  const std::string path = (std::filesystem::path(folder) / (title + "-" + layers[layer_].word + suffix())).string();
  if (path_.empty() || path_ == proposed_) path_ = path;
  proposed_ = path;
}

/// The format is what the file's name says.
void ExportFormPanel::follow_suffix() {
  const std::string given = std::filesystem::path(path_).extension().string();
  for (int i = 0; i < static_cast<int>(std::size(formats)); ++i) {
    if (given == formats[i].suffix) format_ = i;
  }
}

void ExportFormPanel::draw(Widgets& w, Frame& frame) {
  draw_format(w, frame);
  draw_crs(w, frame);
  w.text("File", TextRole::table, Tone::secondary);
  const std::string before = path_;
  if (w.path_field("export/path", path_, "export/browse")) frame.view.dialog = Dialog::export_path;
  if (path_ != before) follow_suffix();
  draw_preview(w, frame);
  if (w.button("export/run", "Export", {.primary = true, .width = -1.0f, .why_not = why_not(frame)})) {
    frame.requests.emit(request::Export{path_, layers[layer_].word, frame.view.exporting.epsg, decimal_comma_, semicolon_});
  }
}

std::string ExportFormPanel::why_not(const Frame& frame) const {
  const std::string& no_trees = frame.available[static_cast<std::size_t>(ActionId::export_run)].why_not;
  if (!no_trees.empty()) return no_trees;
  if (path_.empty()) return "Give a file name";
  const bool placed = frame.state().georeference.kind != GeoreferenceKind::none;
  return !placed && (crs_ != 0 || formats[format_].on_earth) ? "The project is not on the earth yet: georeference it in step 4 first" : "";
}

void ExportFormPanel::draw_format(Widgets& w, Frame& frame) {
  std::vector<std::string> labels;
  for (const Layer& l : layers) labels.emplace_back(l.label);
  w.text("What", TextRole::table, Tone::secondary);
  w.combo("export/layer", labels, layer_);
  frame.view.exporting.layer = layers[layer_].word;
  w.paragraph(layers[layer_].help, TextRole::caption, Tone::secondary);
  labels.clear();
  for (const Format& f : formats) labels.emplace_back(f.label);
  w.text("Format", TextRole::table, Tone::secondary);
  if (w.combo("export/format", labels, format_) && !path_.empty()) path_ = std::filesystem::path(path_).replace_extension(suffix()).string();
  if (suffix() != ".csv") return;
  w.checkbox("export/decimal_comma", "Decimal comma", decimal_comma_, "As German Excel wants it: also a mark that the text is UTF-8");
  w.checkbox("export/semicolon", "Semicolon between columns", semicolon_);
}

void ExportFormPanel::draw_crs(Widgets& w, Frame& frame) {
  const Georeference& g = frame.state().georeference;
  const bool placed = g.kind != GeoreferenceKind::none;
  w.text("Coordinates", TextRole::table, Tone::secondary);
  const std::string own = placed ? crs_words(g) : "Local (metres)";
  w.combo("export/crs", {own, "WGS 84 (longitude, latitude)", "Other EPSG number"}, crs_);
  if (crs_ == 2) w.number("export/epsg", epsg_, "%.0f");
  frame.view.exporting.epsg = crs_ == 1 ? 4326 : crs_ == 2 ? static_cast<int>(std::clamp(epsg_, 0.0, 99999.0)) : 0;
  if (!placed && (crs_ != 0 || formats[format_].on_earth)) w.paragraph("The project is not on the earth yet: georeference it in step 4 first.", TextRole::table, Tone::warning);
}

/// How many rows there are, in which system, and the first one.
void ExportFormPanel::draw_preview(Widgets& w, Frame& frame) {
  const std::optional<ExportPreview>& preview = frame.status.exporting;
  if (!preview) {  // as high as what comes: the button below must not move away from the mouse
    w.text("Working it out…", TextRole::table, Tone::secondary);
    ImGui::Dummy({1.0f, w.px(28)});
    return;
  }
  for (const Issue& issue : preview->issues) w.paragraph(to_string(issue), TextRole::table, Tone::warning);
  if (preview->system.empty()) return;
  const std::string summary = plural(preview->rows, "row", "rows") + " of " + plural(static_cast<std::int64_t>(preview->first.size()), "column", "columns") + " in " + preview->system;
  w.paragraph(summary, TextRole::table, Tone::secondary);
  w.record_last("export/preview", summary);
  if (preview->first.empty() || !w.fold("export/first", "The first row", preview_open_)) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (std::size_t i = 0; i < std::min(preview->first.size(), first_values); ++i) w.fact("export/first/" + preview->first[i].first, preview->first[i].first, preview->first[i].second.empty() ? dash : preview->first[i].second);
  ImGui::PopStyleVar();
  if (preview->first.size() > first_values) w.text("and " + count_text(static_cast<std::int64_t>(preview->first.size() - first_values)) + " more", TextRole::caption, Tone::secondary);
}

}  // namespace stemwise::ui
