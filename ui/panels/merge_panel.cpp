#include "ui/panels/merge_panel.hpp"

#include <imgui.h>

#include <cmath>

#include "ui/text/format.hpp"
#include "ui/text/georeference_words.hpp"

namespace stemwise::ui {
namespace {

struct Policy {
  FusionPolicy policy;
  const char* label;
  const char* help;
};
constexpr Policy policies[] = {
    {FusionPolicy::min_dbh, "Smallest DBH", "The smallest measured DBH: careful where LiDAR tends to measure too thick."},
    {FusionPolicy::newest, "Newest", "The latest survey that measured the tree."},
    {FusionPolicy::best, "Best", "The survey with the smallest estimated error."},
    {FusionPolicy::mean, "Mean", "The mean of all surveys, weighted by their errors."},
};

void labelled_number(Widgets& w, const char* path, const char* name, double& value, const char* format) {
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in({row.x, row.y, row.width * 0.52f, row.height}, name, TextRole::body, Tone::secondary);
  ImGui::SetCursorScreenPos({row.x + row.width * 0.54f, row.y});
  w.number(path, value, format);
}

/// Why there is nothing to do with what the form says; "" when there is.
std::string problem_of(const Georeference& g, const Georeference& now) {
  if (g.origin == Geodetic{} && g.azimuth_deg == 0.0) return "Enter where the reference's origin lies first.";
  if (now.kind == GeoreferenceKind::anchor && g.origin == now.origin && g.azimuth_deg == now.azimuth_deg && g.sd_m == now.sd_m) return "The project lies there already.";
  if (std::abs(g.origin.latitude_deg) > 90.0) return "A latitude lies between −90° and 90°.";
  if (std::abs(g.origin.longitude_deg) > 180.0) return "A longitude lies between −180° and 180°.";
  if (g.azimuth_deg < -360.0 || g.azimuth_deg > 360.0) return "An azimuth lies between 0° and 360°.";
  return "";
}

}  // namespace

void MergePanel::draw(Widgets& w, Frame& frame) {
  if (loaded_ != frame.revision) {
    loaded_ = frame.revision;
    load(frame.state().georeference);
  }
  w.text("Merge and georeference", TextRole::title);
  draw_fusion(w, frame);
  draw_place(w, frame);
  w.gap(12);
  if (w.button("merge/next", "Go on to report and export", {.width = -1.0f, .key = "5"})) frame.requests.run(ActionId::step_report);
}

void MergePanel::load(const Georeference& from) {
  form_ = from;
  kind_ = from.kind == GeoreferenceKind::crs ? 1 : 0;
}

void MergePanel::draw_fusion(Widgets& w, Frame& frame) {
  w.section("A merged tree takes its DBH from");
  const std::vector<std::string> labels{policies[0].label, policies[1].label, policies[2].label, policies[3].label};
  int current = 0;
  for (int i = 0; i < 4; ++i) {
    if (policies[i].policy == frame.state().fusion) current = i;
  }
  if (w.combo("merge/policy", labels, current)) frame.requests.emit(request::SetFusion{policies[current].policy});
  w.paragraph(policies[current].help, TextRole::table, Tone::secondary);
  const auto trees = static_cast<std::int64_t>(frame.tables().trees.size());
  w.paragraph(plural(trees, "merged tree", "merged trees") + "; every value names the survey that it came from.", TextRole::table, Tone::secondary);
}

void MergePanel::draw_place(Widgets& w, Frame& frame) {
  w.section("Place on the earth");
  const Georeference& now = frame.state().georeference;
  const std::string state = now.kind == GeoreferenceKind::none ? "Not georeferenced: exports carry local coordinates." : "Georeferenced by " + now.method + (crs_words(now) == now.method ? "" : ": " + crs_words(now)) + ".";
  w.paragraph(state, TextRole::table, now.kind == GeoreferenceKind::none ? Tone::secondary : Tone::accent);
  w.record_last("merge/place", state);
  const float half = 0.5f * (w.available_width() - w.px(8));
  const Rect row = w.next_rect(2 * half, w.px(30));
  if (w.button_in({row.x, row.y, half, row.height}, "merge/kind/anchor", "Anchor", {.active = kind_ == 0, .tooltip = "Position of the reference's origin, and where its y axis points"})) kind_ = 0;
  if (w.button_in({row.x + half + w.px(8), row.y, half, row.height}, "merge/kind/crs", "Known CRS", {.active = kind_ == 1, .tooltip = "The reference's coordinates are those of a map projection already"})) kind_ = 1;
  w.gap(6);
  kind_ == 0 ? draw_anchor(w, frame) : draw_crs(w, frame);
  if (now.kind != GeoreferenceKind::none && w.button("merge/clear", "Back to local coordinates", {.width = -1.0f})) frame.requests.emit(request::SetGeoreference{Georeference{}});
}

void MergePanel::draw_anchor(Widgets& w, Frame& frame) {
  labelled_number(w, "merge/lat", "Latitude, °", form_.origin.latitude_deg, "%.8f");
  labelled_number(w, "merge/lon", "Longitude, °", form_.origin.longitude_deg, "%.8f");
  labelled_number(w, "merge/height", "Height above ellipsoid, m", form_.origin.height_m, "%.2f");
  labelled_number(w, "merge/azimuth", "Azimuth of the y axis, °", form_.azimuth_deg, "%.3f");
  labelled_number(w, "merge/sd", "Uncertainty (1 sd), m", form_.sd_m, "%.2f");
  w.paragraph("The position of the reference's origin; the azimuth counts clockwise from true north.", TextRole::caption, Tone::secondary);
  const std::string problem = problem_of(form_, frame.state().georeference);
  const bool wrong = std::abs(form_.origin.latitude_deg) > 90.0 || std::abs(form_.origin.longitude_deg) > 180.0 || std::abs(form_.azimuth_deg) > 360.0;
  if (wrong) w.paragraph(problem, TextRole::table, Tone::warning);
  if (w.button("merge/apply", "Place the project", {.primary = true, .width = -1.0f, .why_not = problem})) {
    Georeference g = form_;
    g.kind = GeoreferenceKind::anchor;
    g.epsg = 0;
    g.method = "anchor";
    g.residuals.clear();
    frame.requests.emit(request::SetGeoreference{g});
  }
}

void MergePanel::draw_crs(Widgets& w, Frame& frame) {
  double epsg = form_.epsg;
  labelled_number(w, "merge/epsg", "EPSG number", epsg, "%.0f");
  form_.epsg = static_cast<int>(epsg);
  w.paragraph("For example 25832 for ETRS89 / UTM zone 32N. Heights are kept.", TextRole::caption, Tone::secondary);
  const std::string problem = form_.epsg >= 1024 && form_.epsg <= 32767 ? "" : "An EPSG number has four or five digits, for example 25832.";
  const Georeference& now = frame.state().georeference;
  const bool same = now.kind == GeoreferenceKind::crs && now.epsg == form_.epsg;
  const std::string why_not = same ? "The project has this CRS already." : problem;
  if (w.button("merge/apply", "Place the project", {.primary = true, .width = -1.0f, .why_not = why_not})) {
    Georeference g;
    g.kind = GeoreferenceKind::crs;
    g.epsg = form_.epsg;
    g.method = "EPSG:" + std::to_string(form_.epsg);
    frame.requests.emit(request::SetGeoreference{g});
  }
}

}  // namespace stemwise::ui
