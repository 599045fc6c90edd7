#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

#include "app/commands/placement.hpp"
#include "app/window/previews.hpp"
#include "core/survey/tables.hpp"
#include "io/earth_frame.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

bool is_file(const std::string& path) {
  std::error_code error;
  return !path.empty() && std::filesystem::is_regular_file(path, error);
}

GeoreferenceOptions options_of(const ui::PlacementForm& form, const ProjectState& state) {
  static constexpr const char* kinds[] = {"true", "grid", "magnetic"};
  GeoreferenceOptions options;
  char text[160];
  std::snprintf(text, sizeof text, "%.17g,%.17g,%.17g,%.17g", form.latitude_deg, form.longitude_deg, form.height_m, form.azimuth_deg);
  if (form.way == ui::PlaceWay::anchor) options.anchor = text;
  if (form.way == ui::PlaceWay::crs) options.crs = "EPSG:" + std::to_string(form.epsg);
  if (form.way == ui::PlaceWay::gnss) options.gnss = form.gnss_file;
  if (form.way == ui::PlaceWay::control) options.control = is_file(form.control_file) ? form.control_file : "";
  options.azimuth_kind = kinds[std::clamp(form.azimuth_kind, 0, 2)];
  if (form.azimuth_kind == 2 && form.declination_deg != 0.0) options.declination_deg = form.declination_deg;
  options.translation_only = form.way == ui::PlaceWay::control && form.translation_only;
  if (options.translation_only) options.azimuth_deg = form.azimuth_deg;
  options.level = form.level == 1;
  options.tilted = form.level == 2;
  options.outlier_m = form.outlier_m;
  options.geoid = form.geoid;
  if (const Inventory* inventory = state.find(form.inventory)) options.inventory = inventory->name;
  if (form.sd_m > 0.0) options.sd_m = form.sd_m;
  options.time_offset_s = form.time_offset_s;
  return options;
}

std::vector<ControlRow> rows_of(const std::vector<ui::TypedControl>& typed) {
  std::vector<ControlRow> rows;
  for (const ui::TypedControl& point : typed) {
    ControlRow row;
    row.row = static_cast<std::int64_t>(rows.size()) + 1;
    row.tree_id = tree_label(point.tree);
    row.on_earth = {point.latitude_deg, point.longitude_deg, point.height_m};
    row.has_height = point.has_height;
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The command line's words without its options: "--crs EPSG:1: there is no such code".
Issue in_plain_words(Issue issue) {
  if (issue.text.starts_with("--")) {
    const std::size_t end = issue.text.find_first_of(" :");
    if (end != std::string::npos) issue.text.erase(0, issue.text[end] == ':' ? end + 2 : end + 1);
  }
  if (issue.help.find("--") != std::string::npos) issue.help.clear();
  return issue;
}

/// Where the middle of the reference's stems comes to lie.
std::string middle_in_words(const Georeference& georeference, const ProjectState& state) {
  const Inventory* reference = state.find(state.reference);
  const auto frame = EarthFrame::of(georeference);
  if (reference == nullptr || reference->stems.empty() || !frame) return "";
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
  for (const Stem& stem : reference->stems) middle_m += Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0)) / static_cast<double>(reference->stems.size());
  const auto earth = frame->geodetic_from_reference(middle_m);
  const auto projected = frame->target_from_reference(middle_m);
  if (!earth) return "";
  std::string words = ui::fixed(std::abs(earth->latitude_deg), 6) + (earth->latitude_deg < 0.0 ? "° S, " : "° N, ") + ui::fixed(std::abs(earth->longitude_deg), 6) +
                      (earth->longitude_deg < 0.0 ? "° W" : "° E");
  if (projected && frame->epsg()) words += "\nEPSG:" + std::to_string(*frame->epsg()) + ", " + ui::grouped(projected->x(), 1) + " E, " + ui::grouped(projected->y(), 1) + " N";
  return words;
}

}  // namespace

bool is_complete(const ui::PlacementForm& form) {
  switch (form.way) {
    case ui::PlaceWay::anchor: return form.latitude_deg != 0.0 || form.longitude_deg != 0.0;
    case ui::PlaceWay::control: return is_file(form.control_file) || !form.typed.empty();
    case ui::PlaceWay::gnss: return is_file(form.gnss_file);
    case ui::PlaceWay::crs: return form.epsg >= 1024;
  }
  return false;
}

ui::PlacementPreview preview_placement(const ui::PlacementForm& form, const ProjectState& state) {
  ui::PlacementPreview preview;
  preview.form = form;
  const Placement placement = place_project(options_of(form, state), state, rows_of(form.way == ui::PlaceWay::control ? form.typed : std::vector<ui::TypedControl>{}));
  preview.usable = placement.code == ExitCode::done;
  preview.georeference = placement.georeference;
  if (placement.places_m.size() == placement.georeference.residuals.size()) preview.places_m = placement.places_m;
  if (!placement.said.empty()) preview.said.push_back(placement.said.back());
  for (std::string& line : preview.said) line.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(line.front())));
  for (const Issue& issue : placement.issues) preview.issues.push_back(in_plain_words(issue));
  if (preview.usable) preview.where = middle_in_words(placement.georeference, state);
  return preview;
}

}  // namespace stemwise
