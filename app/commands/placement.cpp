#include "app/commands/placement.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/geodesy/azimuth.hpp"
#include "core/geodesy/solve_control_points.hpp"
#include "core/geodesy/solve_gnss_track.hpp"
#include "core/survey/tables.hpp"
#include "io/crs.hpp"
#include "io/geoid_grid.hpp"
#include "io/read_control_points.hpp"
#include "io/read_gnss_track.hpp"
#include "io/read_trajectory.hpp"

namespace stemwise {
namespace {

std::optional<std::vector<double>> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  for (const char* at = text.data(); at < text.data() + text.size();) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(at, text.data() + text.size(), number);
    if (error != std::errc{} || !std::isfinite(number) || (end != text.data() + text.size() && *end != ',')) return std::nullopt;
    numbers.push_back(number);
    at = end + 1;
  }
  return numbers;
}

std::string degrees_text(double degrees) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", degrees);
  return text;
}

Placement failed(Issues issues, ExitCode code = ExitCode::failed) {
  Placement placement;
  placement.code = code;
  placement.issues = std::move(issues);
  return placement;
}

Placement refused(ExitCode code, const std::string& text) { return failed({Issue{Severity::error, "", 0, "", text, ""}}, code); }

Placement placed(Georeference georeference) {
  Placement placement;
  placement.georeference = std::move(georeference);
  return placement;
}

void add(Issues& to, const Issues& more) { to.insert(to.end(), more.begin(), more.end()); }

/// The inventory that --inventory names, the reference without it.
Result<const Inventory*> chosen_inventory(const GeoreferenceOptions& options, const ProjectState& state) {
  const auto problem = [](const std::string& text) { return Result<const Inventory*>::failure(Issue{Severity::error, "", 0, "", text, ""}); };
  const Inventory* inventory = options.inventory.empty() ? state.find(state.reference) : state.find(options.inventory);
  if (inventory == nullptr) return problem(options.inventory.empty() ? "the project has no reference" : "--inventory " + options.inventory + ": there is no inventory of that name");
  if (state.is_placed(inventory->id) || inventory->id == state.reference) return inventory;
  return problem("--inventory " + inventory->name + ": it has not been aligned, so its coordinates place nothing");
}

Eigen::Vector3d middle_of(const Inventory& inventory) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Stem& stem : inventory.stems) sum += Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
  return inventory.stems.empty() ? sum : Eigen::Vector3d(sum / static_cast<double>(inventory.stems.size()));
}

std::vector<ControlPoint> control_points(const std::vector<ControlRow>& rows, const Tables& tables, const std::string& file, Issues& issues) {
  std::vector<ControlPoint> points;
  for (const ControlRow& row : rows) {
    ControlPoint point{row.tree_id.empty() ? "row " + std::to_string(row.row) : row.tree_id, {}, row.has_z, row.on_earth, row.has_height};
    if (row.in_reference_m) {
      point.in_reference_m = *row.in_reference_m;
    } else {
      const auto tree = std::find_if(tables.trees.begin(), tables.trees.end(), [&](const TreeRow& t) {
        return tree_label(t.tree) == row.tree_id || std::to_string(t.tree.value) == row.tree_id;
      });
      if (tree == tables.trees.end()) {
        issues.push_back({Severity::warning, file, row.row, "tree_id", "there is no tree '" + row.tree_id + "', the row is left out", ""});
        continue;
      }
      point.in_reference_m = tree->position_m;
      point.has_z = tree->has_z;
    }
    points.push_back(point);
  }
  return points;
}

/// The geoid that --geoid names, about a place: GeographicLib's model of that name, or PROJ's grid. No name: no geoid.
Result<LocalGeoid> named_geoid(const std::string& name, const Geodetic& origin) {
  if (name.empty()) return LocalGeoid{};
  return is_geoid_grid(name) ? local_geoid_of_grid(name, origin) : local_geoid_of_model(name, origin);
}

/// Takes heights above the geoid to heights above the ellipsoid. The geoid is taken about the first of them.
template <class Points>
Issues lift_to_ellipsoid(Points& points, const std::string& name) {
  if (name.empty() || points.empty()) return {};
  Georeference about;
  about.origin = points.front().on_earth;
  const auto geoid = named_geoid(name, about.origin);
  if (!geoid) return geoid.issues;
  about.geoid = *geoid;
  for (auto& point : points) point.on_earth.height_m += geoid_height_m(about, point.on_earth);
  return {};
}

std::vector<std::string> residual_lines(const std::vector<ControlResidual>& residuals) {
  std::vector<std::string> lines;
  for (const ControlResidual& r : residuals) {
    char text[200];
    std::snprintf(text, sizeof text, "%s: residual %.2f m", r.name.c_str(), r.residual_m);
    std::string line = text;
    if (r.leave_one_out_m) {
      std::snprintf(text, sizeof text, ", %.2f m against the others", *r.leave_one_out_m);
      line += text;
    }
    lines.push_back(line + (r.used ? "" : " (left out)"));
  }
  return lines;
}

/// The inventory's stems as control points: what the map says of them, and where the alignment has them.
std::vector<ControlPoint> stems_as_control_points(const Inventory& inventory, const ProjectState& state, const CrsTransform& to_wgs84) {
  std::vector<ControlPoint> points;
  const std::size_t most = 200, n = inventory.stems.size(), wanted = std::min(most, n);
  for (std::size_t k = 0; k < wanted; ++k) {
    const std::size_t i = k * n / wanted;
    const Stem& stem = inventory.stems[i];
    const auto at = to_wgs84({stem.x_m, stem.y_m, stem.z_m.value_or(0.0)});
    if (!at) continue;
    const StemRef ref{inventory.id, static_cast<std::int64_t>(i)};
    points.push_back({stem.source_id, state.stem_in_reference_m(ref), stem.z_m.has_value(), {at->y(), at->x(), at->z()}, stem.z_m.has_value()});
  }
  return points;
}

Placement place_by_crs_of_another(const GeoreferenceOptions& options, const ProjectState& state, int epsg, const Inventory& inventory) {
  const auto to_wgs84 = CrsTransform::between(epsg, wgs84_epsg);
  if (!to_wgs84) return failed(to_wgs84.issues);
  std::vector<ControlPoint> points = stems_as_control_points(inventory, state, *to_wgs84);
  if (Issues issues = lift_to_ellipsoid(points, options.geoid); has_error(issues)) return failed(issues);
  ControlSettings settings;
  settings.level = LevelChoice::level;
  const auto report = solve_control_points(points, settings);
  if (!report) return failed(report.issues);
  Placement placement = placed(report->georeference);
  // The stems share the error of the coordinates' origin: what they say of each other is no measure of it.
  placement.georeference.sd_m = options.sd_m.value_or(0.0);
  placement.georeference.residuals.clear();
  placement.georeference.method = "CRS of " + inventory.name + ", " + crs_name(epsg);
  return placement;
}

std::vector<TrackPoint> track_points(const std::vector<std::optional<TrajectoryPose>>& poses, const RigidTransform& reference_from_inventory) {
  std::vector<TrackPoint> track;
  for (const auto& pose : poses)
    if (pose) track.push_back({pose->timestamp_s, reference_from_inventory * pose->survey_from_frame.translation_m});
  return track;
}

LevelChoice level_choice(const GeoreferenceOptions& options) {
  return options.level ? LevelChoice::level : options.tilted ? LevelChoice::tilted : LevelChoice::automatic;
}

/// The azimuth in degrees clockwise from true north, whichever north the person counted from.
Result<double> true_azimuth_deg(double azimuth_deg, const GeoreferenceOptions& options, const ProjectState& state, const Geodetic& at) {
  const auto kind = azimuth_kind_from(options.azimuth_kind);
  if (kind == AzimuthKind::grid) {
    const auto convergence_deg = utm_convergence_deg(at);
    if (!convergence_deg) return Result<double>::failure(Issue{Severity::error, "", 0, "", "there is no UTM grid here to count an azimuth from", "give the azimuth from true north"});
    return azimuth_deg + *convergence_deg;
  }
  if (kind != AzimuthKind::magnetic) return azimuth_deg;
  if (options.declination_deg) return azimuth_deg + *options.declination_deg;
  const Inventory* reference = state.find(state.reference);
  if (reference == nullptr || !reference->date)
    return Result<double>::failure(Issue{Severity::error, "", 0, "", "the reference has no date, so nobody knows the magnetic declination of its day", "give --declination DEG (east is positive)"});
  const auto declination = declination_deg(at, *reference->date, options.magnetic_model);
  if (!declination) return declination;
  return azimuth_deg + *declination;
}

Placement place_by_anchor(const GeoreferenceOptions& options, const ProjectState& state) {
  const std::string& text = options.anchor;
  const auto numbers = numbers_of(text);
  if (!numbers || numbers->size() != 4)
    return refused(ExitCode::usage, "--anchor " + text + ": expected LAT,LON,H,AZIMUTH, for example 48.77214,9.16621,412.5,37");
  if ((*numbers)[0] < -80.0 || (*numbers)[0] > 84.0 || std::abs((*numbers)[1]) > 180.0)
    return refused(ExitCode::usage, "--anchor " + text + ": expected a latitude of -80 to 84 degrees (where UTM reaches) and a longitude of -180 to 180");
  if (std::abs((*numbers)[2]) > 12000.0 || std::abs((*numbers)[3]) > 360.0)
    return refused(ExitCode::usage, "--anchor " + text + ": expected a height in metres and an azimuth of -360 to 360 degrees");
  Georeference georeference;
  georeference.kind = GeoreferenceKind::anchor;
  georeference.origin = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  const auto azimuth = true_azimuth_deg((*numbers)[3], options, state, georeference.origin);
  if (!azimuth) return failed(azimuth.issues);
  const auto geoid = named_geoid(options.geoid, georeference.origin);
  if (!geoid) return failed(geoid.issues);
  georeference.origin.height_m += geoid->height_m;
  georeference.azimuth_deg = *azimuth;
  georeference.sd_m = options.sd_m.value_or(0.0);
  georeference.method = "anchor";
  return placed(std::move(georeference));
}

Placement place_by_crs(const GeoreferenceOptions& options, const ProjectState& state) {
  const std::optional<int> epsg = epsg_from(options.crs);
  if (!epsg) return refused(ExitCode::usage, "--crs " + options.crs + ": expected EPSG:N, for example EPSG:32632");
  const auto inventory = chosen_inventory(options, state);
  if (!inventory) return failed(inventory.issues, ExitCode::usage);
  Placement placement = place_in_crs(*epsg, **inventory);
  if (placement.code != ExitCode::done) return placement;
  if ((*inventory)->id != state.reference) return place_by_crs_of_another(options, state, *epsg, **inventory);
  placement.georeference.sd_m = options.sd_m.value_or(0.0);
  return placement;
}

Placement place_by_control_points(const GeoreferenceOptions& options, const ProjectState& state, const std::vector<ControlRow>& typed) {
  std::vector<ControlRow> rows = typed;
  Issues issues;
  if (!options.control.empty()) {
    const auto read = read_control_points(options.control);
    add(issues, read.issues);
    if (!read) return failed(std::move(issues), ExitCode::unusable_input);
    rows.insert(rows.end(), read->begin(), read->end());
  }
  std::vector<ControlPoint> points = control_points(rows, derive_tables(state), options.control, issues);
  if (const Issues wrong = lift_to_ellipsoid(points, options.geoid); has_error(wrong)) return failed(wrong);
  ControlSettings settings;
  settings.level = level_choice(options);
  settings.translation_only = options.translation_only;
  settings.outlier_m = options.outlier_m;
  if (options.translation_only && !points.empty()) {
    const auto azimuth = true_azimuth_deg(*options.azimuth_deg, options, state, points.front().on_earth);
    if (!azimuth) return failed(azimuth.issues);
    settings.azimuth_deg = *azimuth;
  }
  const Result<ControlReport> report = solve_control_points(points, settings);
  add(issues, report.issues);
  if (!report) return failed(std::move(issues));
  Placement placement = placed(report->georeference);
  placement.issues = std::move(issues);
  for (const ControlPoint& point : points) placement.places_m.push_back(point.in_reference_m);
  placement.said = residual_lines(report->georeference.residuals);
  char text[160];
  std::snprintf(text, sizeof text, "%s: RMS %.2f m in the plane%s", report->georeference.method.c_str(), report->rms_m,
                report->tilted ? (", the frame leans " + std::to_string(report->georeference.roll_deg) + " and " + std::to_string(report->georeference.pitch_deg) + " degrees").c_str() : "");
  placement.said.emplace_back(text);
  return placement;
}

Placement place_by_gnss(const GeoreferenceOptions& options, const ProjectState& state) {
  const auto inventory = chosen_inventory(options, state);
  if (!inventory) return failed(inventory.issues, ExitCode::usage);
  auto fixes = read_gnss_track(options.gnss);
  Issues issues = fixes.issues;
  if (!fixes) return failed(std::move(issues), ExitCode::unusable_input);
  const std::string path = options.trajectory.empty() ? (std::filesystem::path((*inventory)->source.path) / "trajectory.txt").string() : options.trajectory;
  const auto poses = read_trajectory(path);
  add(issues, poses.issues);
  if (!poses) {
    issues.push_back({Severity::error, "", 0, "", "--gnss: a track is joined to the trajectory of " + (*inventory)->name + " by time, and that cannot be read", "--trajectory names it where the frame folder has moved; or use --control"});
    return failed(std::move(issues), ExitCode::unusable_input);
  }
  if (const Issues wrong = lift_to_ellipsoid(*fixes, options.geoid); has_error(wrong)) return failed(wrong);
  GnssSettings settings;
  settings.time_offset_s = options.time_offset_s;
  const auto report = solve_gnss_track(track_points(*poses, state.reference_from_inventory((*inventory)->id)), *fixes, settings);
  add(issues, report.issues);
  if (!report) return failed(std::move(issues));
  Placement placement = placed(report->georeference);
  placement.issues = std::move(issues);
  placement.said = residual_lines(report->georeference.residuals);
  char text[160];
  std::snprintf(text, sizeof text, "GNSS track: %d of %d fixes used, RMS %.2f m in the plane, azimuth %.2f° ± %.2f°", report->used, report->fixes, report->rms_m,
                report->georeference.azimuth_deg, report->georeference.azimuth_sd_deg);
  placement.said.emplace_back(text);
  return placement;
}

Placement place(const GeoreferenceOptions& options, const ProjectState& state, const std::vector<ControlRow>& typed) {
  if (!options.anchor.empty()) return place_by_anchor(options, state);
  if (!options.crs.empty()) return place_by_crs(options, state);
  if (!options.gnss.empty()) return place_by_gnss(options, state);
  return place_by_control_points(options, state, typed);
}

}  // namespace

Placement place_in_crs(int epsg, const Inventory& inventory) {
  const std::string option = "--crs EPSG:" + std::to_string(epsg) + ": ";
  if (!is_known_epsg(epsg)) return refused(ExitCode::usage, option + "there is no such code");
  if (is_geographic_epsg(epsg)) return refused(ExitCode::usage, option + "the coordinates are metres, so a projected system is needed");
  const Eigen::Vector3d middle_m = middle_of(inventory);
  const auto to_wgs84 = CrsTransform::between(epsg, wgs84_epsg);
  const auto middle = to_wgs84 ? (*to_wgs84.value)(middle_m) : std::nullopt;
  if (!middle) return refused(ExitCode::failed, option + "the coordinates of " + inventory.name + " have no place in it");
  constexpr double usual_margin_deg = 3.0;  // a country's zone is used a little beyond itself
  const bool looks_local = middle_m.head<2>().cwiseAbs().maxCoeff() < 20000.0;
  if (!is_in_area_of_use(epsg, middle->y(), middle->x(), looks_local ? 0.0 : usual_margin_deg))
    return refused(ExitCode::failed, option + "the coordinates of " + inventory.name + " would lie at latitude " + degrees_text(middle->y()) + ", longitude " +
                                                            degrees_text(middle->x()) + ", where this system is not used; are they local coordinates? Then an anchor or control points place them");
  Georeference georeference;
  georeference.kind = GeoreferenceKind::crs;
  georeference.epsg = epsg;
  georeference.origin = {middle->y(), middle->x(), middle->z()};
  georeference.anchored_point_m = middle_m;
  georeference.method = "CRS " + crs_name(epsg);
  return placed(std::move(georeference));
}

Placement place_project(const GeoreferenceOptions& options, const ProjectState& state, const std::vector<ControlRow>& typed) {
  Placement placement = place(options, state, typed);
  if (placement.code != ExitCode::done) return placement;
  const auto geoid = named_geoid(options.geoid, placement.georeference.origin);
  add(placement.issues, geoid.issues);
  if (!geoid) return failed(std::move(placement.issues));
  placement.georeference.geoid = *geoid;
  return placement;
}

void tell(const Placement& placement, Console& console) {
  for (const std::string& line : placement.said) console.say(line);
  console.issues(placement.issues);
}

}  // namespace stemwise
