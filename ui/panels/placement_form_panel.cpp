#include "ui/panels/placement_form_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/text/format.hpp"
#include "ui/text/georeference_words.hpp"

namespace stemwise::ui {
namespace {

void labelled_number(Widgets& w, const char* path, const char* name, double& value, const char* format, const char* hint = "", const char* at_zero = nullptr) {
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in({row.x, row.y, row.width * 0.52f, row.height}, name, TextRole::body, Tone::secondary);
  ImGui::SetCursorScreenPos({row.x + row.width * 0.54f, row.y});
  w.number(path, value, format, 0.0f, at_zero);
  if (*hint != '\0' && ImGui::IsItemHovered()) w.tooltip(hint);
}

/// What is wrong with the form itself; "" when nothing is.
std::string problem_of(const PlacementForm& form) {
  if (form.way == PlaceWay::anchor && form.latitude_deg == 0.0 && form.longitude_deg == 0.0) return "Enter where the reference's origin lies first";
  if (std::abs(form.latitude_deg) > 90.0) return "A latitude lies between −90° and 90°";
  if (std::abs(form.longitude_deg) > 180.0) return "A longitude lies between −180° and 180°";
  if (std::abs(form.azimuth_deg) > 360.0) return "An azimuth lies between 0° and 360°";
  if (form.way == PlaceWay::control && form.control_file.empty() && form.typed.empty()) return "Choose a file of control points, or type the place of a tree";
  if (form.way == PlaceWay::gnss && form.gnss_file.empty()) return "Choose the file of the GNSS track";
  if (form.way == PlaceWay::crs && (form.epsg < 1024 || form.epsg > 32767)) return "An EPSG number has four or five digits, for example 25832";
  return "";
}

bool is_same_place(const Georeference& a, const Georeference& b) {
  return a.kind == b.kind && a.origin == b.origin && a.azimuth_deg == b.azimuth_deg && a.epsg == b.epsg && a.sd_m == b.sd_m && a.geoid == b.geoid && a.method == b.method;
}

}  // namespace

void PlacementFormPanel::draw(Widgets& w, Frame& frame) {
  const Georeference& now = frame.state().georeference;
  if (loaded_ != frame.revision && !(shown_ == now)) {
    shown_ = now;
    PlacementForm& form = frame.view.placement;
    if (now.kind == GeoreferenceKind::crs) form.epsg = now.epsg;
    if (now.kind == GeoreferenceKind::anchor && now.residuals.empty() && now.anchored_point_m.isZero()) {
      form.latitude_deg = now.origin.latitude_deg;
      form.longitude_deg = now.origin.longitude_deg;
      form.height_m = now.origin.height_m - now.geoid.height_m;
      form.azimuth_deg = now.azimuth_deg;
      form.azimuth_kind = 0;
      form.sd_m = now.sd_m;
    }
  }
  loaded_ = frame.revision;
  w.section("Place on the earth");
  const std::string state = now.kind == GeoreferenceKind::none ? "Not georeferenced: exports carry local coordinates." : "Georeferenced by " + now.method + (crs_words(now) == now.method ? "" : ": " + crs_words(now)) + ".";
  w.paragraph(state, TextRole::table, now.kind == GeoreferenceKind::none ? Tone::secondary : Tone::accent);
  w.record_last("merge/place", state);
  draw_ways(w, frame);
  switch (frame.view.placement.way) {
    case PlaceWay::anchor: draw_anchor(w, frame); break;
    case PlaceWay::control: draw_control(w, frame); break;
    case PlaceWay::gnss: draw_gnss(w, frame); break;
    case PlaceWay::crs: draw_crs(w, frame); break;
  }
  draw_preview(w, frame);
  if (now.kind != GeoreferenceKind::none && w.button("merge/clear", "Back to local coordinates", {.width = -1.0f})) frame.requests.emit(request::SetGeoreference{Georeference{}});
}

void PlacementFormPanel::draw_ways(Widgets& w, Frame& frame) {
  struct Way { PlaceWay way; const char* path; const char* label; const char* help; };
  static constexpr Way ways[] = {{PlaceWay::control, "merge/kind/control", "Control points", "Trees or points whose place on the earth is known: two when the frame is level, more are better"},
                                 {PlaceWay::anchor, "merge/kind/anchor", "Anchor", "Position of the reference's origin, and where its y axis points"},
                                 {PlaceWay::gnss, "merge/kind/gnss", "GNSS track", "A receiver that travelled with the scanner"},
                                 {PlaceWay::crs, "merge/kind/crs", "Known CRS", "A survey's coordinates are those of a map projection already"}};
  const float gap = w.px(6), height = w.px(30), each = 0.5f * (w.available_width() - gap);
  const Rect block = w.next_rect(w.available_width(), 2 * height + gap);
  for (int i = 0; i < 4; ++i) {
    const Way& way = ways[i];
    const Rect rect{block.x + static_cast<float>(i % 2) * (each + gap), block.y + static_cast<float>(i / 2) * (height + gap), each, height};
    if (w.button_in(rect, way.path, way.label, {.active = frame.view.placement.way == way.way, .tooltip = way.help})) frame.view.placement.way = way.way;
  }
  w.gap(6);
}

void PlacementFormPanel::draw_anchor(Widgets& w, Frame& frame) {
  PlacementForm& form = frame.view.placement;
  labelled_number(w, "merge/lat", "Latitude, °", form.latitude_deg, "%.8f", "North is positive", "decimal degrees");
  labelled_number(w, "merge/lon", "Longitude, °", form.longitude_deg, "%.8f", "East is positive", "decimal degrees");
  labelled_number(w, "merge/height", "Height, m", form.height_m, "%.2f", "Above the ellipsoid, or above the geoid that is named below");
  draw_azimuth(w, frame);
  labelled_number(w, "merge/sd", "Uncertainty (1 sd), m", form.sd_m, "%.2f");
  if (w.fold("merge/more", "Heights", more_open_)) draw_geoid(w, frame);
}

void PlacementFormPanel::draw_azimuth(Widgets& w, Frame& frame) {
  PlacementForm& form = frame.view.placement;
  labelled_number(w, "merge/azimuth", "Azimuth of the y axis, °", form.azimuth_deg, "%.3f", "Clockwise from north");
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in({row.x, row.y, row.width * 0.52f, row.height}, "It counts from", TextRole::body, Tone::secondary);
  ImGui::SetCursorScreenPos({row.x + row.width * 0.54f, row.y});
  w.combo("merge/azimuth_kind", {"true north", "grid north (UTM)", "magnetic north"}, form.azimuth_kind, row.width * 0.46f);
  if (form.azimuth_kind == 2) labelled_number(w, "merge/declination", "Declination, °", form.declination_deg, "%.2f", "Of the needle, east is positive; empty: by the model of the earth's field on the reference's date", "by the model");
}

void PlacementFormPanel::draw_geoid(Widgets& w, Frame& frame) {
  w.text("Heights are above", TextRole::table, Tone::secondary);
  w.input("merge/geoid", frame.view.placement.geoid, {.hint = "the ellipsoid; or a geoid: egm2008-5, a grid file"});
}

void PlacementFormPanel::draw_file(Widgets& w, Frame& frame, const char* path, std::string& file, Dialog dialog, const char* columns) {
  if (w.path_field(path, file, std::string(path) + "/browse", {.hint = "A table, .csv"})) frame.view.dialog = dialog;
  w.paragraph(std::string("Columns: ") + columns, TextRole::caption, Tone::secondary);
}

void PlacementFormPanel::draw_control(Widgets& w, Frame& frame) {
  PlacementForm& form = frame.view.placement;
  draw_file(w, frame, "merge/control_file", form.control_file, Dialog::control_file, "tree_id or x_m and y_m (z_m), and lat, lon, height_m");
  draw_typed(w, frame);
  w.checkbox("merge/translation_only", "Keep the direction, only move", form.translation_only, "One point is enough then; the azimuth of the y axis is given");
  if (form.translation_only) draw_azimuth(w, frame);
  if (!w.fold("merge/more", "Leaning, outliers, heights", more_open_)) return;
  w.combo("merge/level", {"Level or leaning: as the heights say", "The frame is level", "The frame leans"}, form.level);
  labelled_number(w, "merge/outlier", "Left out beyond, m", form.outlier_m, "%.2f", "A point farther than this from what the others agree on is left out");
  draw_geoid(w, frame);
}

/// The selected tree's place on the earth, typed in.
void PlacementFormPanel::draw_typed(Widgets& w, Frame& frame) {
  PlacementForm& form = frame.view.placement;
  std::size_t gone = form.typed.size();
  for (std::size_t i = 0; i < form.typed.size(); ++i) {
    const Rect row = w.next_rect(w.available_width(), w.px(24));
    const std::string words = tree_label(form.typed[i].tree) + ": " + fixed(form.typed[i].latitude_deg, 6) + "°, " + fixed(form.typed[i].longitude_deg, 6) + "°";
    w.text_in({row.x, row.y, row.width - w.px(30), row.height}, words, TextRole::table, Tone::text);
    w.record("merge/typed/" + std::to_string(i), row, words);
    if (w.button_in({row.right() - w.px(24), row.y, w.px(24), w.px(24)}, "merge/typed/drop/" + std::to_string(i), "", {.quiet = true, .icon = icon::cross, .tooltip = "Not this one"})) gone = i;
  }
  if (gone < form.typed.size()) form.typed.erase(form.typed.begin() + static_cast<std::ptrdiff_t>(gone));
  const TreeId tree = frame.view.selected_tree;
  if (!tree) {
    w.paragraph("Or select a tree and type where it stands.", TextRole::table, Tone::secondary);
    return;
  }
  w.text("Or " + tree_label(tree) + " stands at", TextRole::table, Tone::secondary);
  labelled_number(w, "merge/typed/lat", "Latitude, °", latitude_deg_, "%.7f", "WGS 84, north positive", "decimal degrees");
  labelled_number(w, "merge/typed/lon", "Longitude, °", longitude_deg_, "%.7f", "WGS 84, east positive", "decimal degrees");
  labelled_number(w, "merge/typed/height", "Height, m", height_m_, "%.2f", "Above the ellipsoid or the geoid that is chosen below", "not known");
  const std::string why_not = latitude_deg_ == 0.0 && longitude_deg_ == 0.0 ? "Type the latitude and longitude of this tree" : std::abs(latitude_deg_) > 90.0 || std::abs(longitude_deg_) > 180.0 ? "There is no such place" : "";
  if (w.button("merge/typed/add", "Add this point", {.width = -1.0f, .why_not = why_not})) {
    std::erase_if(form.typed, [&](const TypedControl& t) { return t.tree == tree; });
    form.typed.push_back({tree, latitude_deg_, longitude_deg_, height_m_, height_m_ != 0.0});
    latitude_deg_ = longitude_deg_ = height_m_ = 0.0;
  }
}

void PlacementFormPanel::draw_gnss(Widgets& w, Frame& frame) {
  PlacementForm& form = frame.view.placement;
  draw_file(w, frame, "merge/gnss_file", form.gnss_file, Dialog::gnss_file, "timestamp, lat, lon, and height_m, sd_m where they are known");
  w.paragraph("It is joined by time to the trajectory of a survey with frames; multipath is left out.", TextRole::caption, Tone::secondary);
  labelled_number(w, "merge/time_offset", "Add to its clock, s", form.time_offset_s, "%.3f");
  if (w.fold("merge/more", "Heights", more_open_)) draw_geoid(w, frame);
}

void PlacementFormPanel::draw_crs(Widgets& w, Frame& frame) {
  PlacementForm& form = frame.view.placement;
  double epsg = form.epsg;
  labelled_number(w, "merge/epsg", "EPSG number", epsg, "%.0f", "For example 25832 for ETRS89 / UTM zone 32N");
  form.epsg = static_cast<int>(std::clamp(epsg, 0.0, 99999.0));
  std::vector<std::string> names;
  std::vector<InventoryId> ids;
  int current = 0;
  for (const auto& inventory : frame.state().inventories) {
    if (!frame.state().is_placed(inventory->id)) continue;
    if (inventory->id == form.inventory || (!form.inventory && inventory->id == frame.state().reference)) current = static_cast<int>(ids.size());
    ids.push_back(inventory->id);
    names.push_back("Coordinates of " + inventory->name);
  }
  if (w.combo("merge/inventory", names, current)) form.inventory = ids[static_cast<std::size_t>(current)];
  labelled_number(w, "merge/sd", "Uncertainty (1 sd), m", form.sd_m, "%.2f");
}

void PlacementFormPanel::draw_preview(Widgets& w, Frame& frame) {
  const PlacementForm& form = frame.view.placement;
  std::string problem = problem_of(form);
  const std::optional<PlacementPreview>& preview = frame.status.placement;
  const bool ready = problem.empty() && preview && preview->form == form && preview->revision == frame.revision;
  if (ready) {
    w.gap(4);
    for (const std::string& line : preview->said) w.paragraph(line, TextRole::table, Tone::text);
    if (!preview->where.empty()) w.paragraph("The middle of the reference would lie at\n" + preview->where, TextRole::table, Tone::secondary);
    w.record_last("merge/preview", preview->where);
    draw_residuals(w, preview->georeference);
    for (const Issue& issue : preview->issues) w.paragraph(to_string(issue), TextRole::table, Tone::warning);
    if (!preview->usable) problem = preview->issues.empty() ? "This places nothing" : preview->issues.back().text;
    if (preview->usable && is_same_place(preview->georeference, frame.state().georeference)) problem = "The project lies there already";
  } else if (!frame.state().georeference.residuals.empty()) {
    w.text("As it is placed now", TextRole::strong);
    draw_residuals(w, frame.state().georeference);
  }
  if (!ready && problem.empty()) {
    problem = frame.status.placement_busy ? "Working it out…" : "The file cannot be found";
    w.text(problem, TextRole::table, Tone::secondary);
  }
  if (w.button("merge/apply", "Place the project", {.primary = true, .width = -1.0f, .why_not = problem})) frame.requests.emit(request::SetGeoreference{preview->georeference});
}

void PlacementFormPanel::draw_residuals(Widgets& w, const Georeference& georeference) {
  if (georeference.residuals.empty()) return;
  w.gap(4);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  const Rect head = w.next_rect(w.available_width(), w.px(20));
  const float width = head.width;
  w.text_in({head.x, head.y, width * 0.4f, head.height}, "Point", TextRole::caption, Tone::secondary);
  w.text_in({head.x, head.y, width * 0.66f, head.height}, "Residual, m", TextRole::caption, Tone::secondary, Align::right);
  w.text_in(head, "Against others, m", TextRole::caption, Tone::secondary, Align::right);
  ImGui::Dummy({head.width, head.height});
  const std::size_t shown = std::min<std::size_t>(georeference.residuals.size(), 30);
  for (std::size_t i = 0; i < shown; ++i) {
    const ControlResidual& r = georeference.residuals[i];
    const Rect row = w.next_rect(width, w.px(22));
    w.hairline(row.x, row.y, row.right(), row.y + 1);
    const Tone tone = r.used ? Tone::text : Tone::warning;
    w.text_in({row.x, row.y, width * 0.56f, row.height}, r.name + (r.used ? "" : " (left out)"), TextRole::table, tone);
    w.text_in({row.x, row.y, width * 0.66f, row.height}, fixed(r.residual_m, 2), TextRole::table, tone, Align::right);
    w.text_in(row, r.leave_one_out_m ? fixed(*r.leave_one_out_m, 2) : dash, TextRole::table, tone, Align::right);
    w.record("merge/residual/" + r.name, row, fixed(r.residual_m, 2) + (r.used ? "" : " left out"));
    ImGui::Dummy({row.width, row.height});
  }
  ImGui::PopStyleVar();
  if (shown < georeference.residuals.size()) w.text("and " + count_text(static_cast<std::int64_t>(georeference.residuals.size() - shown)) + " more", TextRole::caption, Tone::secondary);
  w.gap(4);
}

}  // namespace stemwise::ui
