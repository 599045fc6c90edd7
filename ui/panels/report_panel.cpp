#include "ui/panels/report_panel.hpp"

#include <imgui.h>

#include <filesystem>

#include "ui/text/format.hpp"
#include "ui/text/georeference_words.hpp"

namespace stemwise::ui {
namespace {

struct Format {
  const char* label;
  const char* suffix;
};
constexpr Format formats[] = {{"GeoPackage (.gpkg)", ".gpkg"}, {"CSV table (.csv)", ".csv"},          {"Workbook (.xlsx)", ".xlsx"},
                              {"GeoJSON (.geojson)", ".geojson"}, {"Shapefile (.shp)", ".shp"},       {"KML (.kml)", ".kml"},
                              {"DXF drawing (.dxf)", ".dxf"},     {"FlatGeobuf (.fgb)", ".fgb"}};

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
};

std::string with_suffix(const std::string& path, const char* suffix) {
  return path.empty() ? path : std::filesystem::path(path).replace_extension(suffix).string();
}

}  // namespace

std::string ReportPanel::suffix() const { return formats[format_].suffix; }

void ReportPanel::start_paths(const Frame& frame) {
  const std::filesystem::path folder = frame.status.project_folder;
  const std::string title = frame.status.project_title.empty() ? "stemwise" : frame.status.project_title;
  const auto propose = [](std::string& field, std::string& proposed, const std::string& path) {
    if (field.empty() || field == proposed) field = path;
    proposed = path;
  };
  propose(export_path_, proposed_export_, (folder / (title + "-trees" + suffix())).string());
  propose(report_path_, proposed_report_, (folder / (title + "-growth.html")).string());
}

void ReportPanel::draw(Widgets& w, Frame& frame) {
  start_paths(frame);
  w.text("Report and export", TextRole::title);
  draw_export(w, frame);
  draw_report(w, frame);
}

void ReportPanel::draw_export(Widgets& w, Frame& frame) {
  w.section("Export");
  draw_format(w);
  draw_crs(w, frame);
  w.text("File", TextRole::table, Tone::secondary);
  if (w.input("export/path", export_path_, {.width = w.available_width() - w.px(92)})) follow_suffix();
  ImGui::SameLine();
  if (w.button("export/browse", "Browse…", {.width = -1.0f})) frame.view.dialog = Dialog::export_path;
  const std::string& no_trees = frame.available[static_cast<std::size_t>(ActionId::export_run)].why_not;
  const std::string why_not = !no_trees.empty() ? no_trees : export_path_.empty() ? "Give a file name" : "";
  if (w.button("export/run", "Export", {.primary = true, .width = -1.0f, .why_not = why_not})) {
    const int epsg = crs_ == 1 ? 4326 : crs_ == 2 ? static_cast<int>(epsg_) : 0;
    frame.requests.emit(request::Export{export_path_, layers[layer_].word, epsg, decimal_comma_, semicolon_});
  }
}

/// The format is what the file's name says.
void ReportPanel::follow_suffix() {
  const std::string given = std::filesystem::path(export_path_).extension().string();
  for (int i = 0; i < static_cast<int>(std::size(formats)); ++i) {
    if (given == formats[i].suffix) format_ = i;
  }
}

void ReportPanel::draw_format(Widgets& w) {
  std::vector<std::string> labels;
  for (const Layer& l : layers) labels.emplace_back(l.label);
  w.text("What", TextRole::table, Tone::secondary);
  w.combo("export/layer", labels, layer_);
  w.paragraph(layers[layer_].help, TextRole::caption, Tone::secondary);
  labels.clear();
  for (const Format& f : formats) labels.emplace_back(f.label);
  w.text("Format", TextRole::table, Tone::secondary);
  if (w.combo("export/format", labels, format_)) export_path_ = with_suffix(export_path_, formats[format_].suffix);
  if (suffix() != ".csv") return;
  w.checkbox("export/decimal_comma", "Decimal comma", decimal_comma_);
  w.checkbox("export/semicolon", "Semicolon between columns", semicolon_);
}

void ReportPanel::draw_crs(Widgets& w, const Frame& frame) {
  const Georeference& g = frame.state().georeference;
  const bool placed = g.kind != GeoreferenceKind::none;
  w.text("Coordinates", TextRole::table, Tone::secondary);
  const std::string own = placed ? crs_words(g) : "Local (metres)";
  w.combo("export/crs", {own, "WGS 84 (longitude, latitude)", "Other EPSG number"}, crs_);
  if (crs_ == 2) w.number("export/epsg", epsg_, "%.0f");
  if (!placed && (crs_ != 0 || suffix() == ".geojson" || suffix() == ".kml")) {
    w.paragraph("The project is not on the earth yet: georeference it in step 4 first.", TextRole::table, Tone::warning);
  }
}

void ReportPanel::draw_report(Widgets& w, Frame& frame) {
  w.gap(12);
  w.section("Growth report");
  w.paragraph("Surveys and alignment quality, matched stems, DBH change with its 20–80 % band, DBH classes, new and missing stems. Suffix .html, .pdf or .csv.",
              TextRole::caption, Tone::secondary);
  w.input("report/path", report_path_, {.width = w.available_width() - w.px(92)});
  ImGui::SameLine();
  if (w.button("report/browse", "Browse…", {.width = -1.0f})) frame.view.dialog = Dialog::report_path;
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in({row.x, row.y, row.width * 0.6f, row.height}, "Area, ha (0: of the coverage)", TextRole::body, Tone::secondary);
  ImGui::SetCursorScreenPos({row.x + row.width * 0.62f, row.y});
  w.number("report/area", area_ha_, "%.3f");
  const std::string& why_not = frame.available[static_cast<std::size_t>(ActionId::export_report)].why_not;
  if (w.button("report/run", "Write the report", {.width = -1.0f, .why_not = why_not})) frame.requests.emit(request::WriteReport{report_path_, area_ha_});
}

}  // namespace stemwise::ui
