#include "app/commands/georeference.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "app/commands/open_project.hpp"
#include "core/geodesy/solve_control_points.hpp"
#include "core/project/commands.hpp"
#include "core/survey/tables.hpp"
#include "io/crs.hpp"
#include "io/read_control_points.hpp"

namespace stemwise {
namespace {

/// What placing a project came to: a georeference, or how the command ends.
struct Placement {
  ExitCode code = ExitCode::done;
  Georeference georeference;
};

Placement usage(Console& console, const std::string& text) {
  console.error(text);
  return {ExitCode::usage, {}};
}

std::optional<std::vector<double>> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  for (const char* at = text.data(); at < text.data() + text.size();) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(at, text.data() + text.size(), number);
    if (error != std::errc{} || (end != text.data() + text.size() && *end != ',')) return std::nullopt;
    numbers.push_back(number);
    at = end + 1;
  }
  return numbers;
}

Placement by_anchor(const std::string& text, Console& console) {
  const auto numbers = numbers_of(text);
  if (!numbers || numbers->size() != 4) return usage(console, "--anchor " + text + ": expected LAT,LON,H,AZIMUTH, for example 48.77214,9.16621,412.5,37");
  const double latitude = (*numbers)[0], longitude = (*numbers)[1];
  if (std::abs(latitude) > 90.0 || std::abs(longitude) > 360.0) return usage(console, "--anchor " + text + ": latitude and longitude are degrees");
  Georeference georeference;
  georeference.kind = GeoreferenceKind::anchor;
  georeference.origin = {latitude, longitude, (*numbers)[2]};
  georeference.azimuth_deg = (*numbers)[3];
  georeference.method = "anchor";
  return {ExitCode::done, georeference};
}

Placement by_crs(const std::string& text, Console& console) {
  int epsg = 0;
  char end = 0;
  if (std::sscanf(text.c_str(), "EPSG:%d%c", &epsg, &end) != 1 && std::sscanf(text.c_str(), "epsg:%d%c", &epsg, &end) != 1) {
    return usage(console, "--crs " + text + ": expected EPSG:N, for example EPSG:32632");
  }
  if (!is_known_epsg(epsg)) return usage(console, "--crs " + text + ": there is no such code");
  if (is_geographic_epsg(epsg)) return usage(console, "--crs " + text + ": the reference's coordinates are metres, so a projected system is needed");
  Georeference georeference;
  georeference.kind = GeoreferenceKind::crs;
  georeference.epsg = epsg;
  georeference.method = "CRS " + crs_name(epsg);
  return {ExitCode::done, georeference};
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

void say_residuals(const ControlReport& report, Console& console) {
  for (const ControlResidual& r : report.residuals) {
    char text[160];
    std::snprintf(text, sizeof text, "%s: residual %.2f m%s", r.name.c_str(), r.residual_m, r.used ? "" : " (left out)");
    std::string line = text;
    if (r.leave_one_out_m) {
      std::snprintf(text, sizeof text, ", %.2f m against the others", *r.leave_one_out_m);
      line += text;
    }
    console.say(line);
  }
}

Placement by_control_points(const std::string& file, const Project& project, Console& console) {
  const auto rows = read_control_points(file);
  console.issues(rows.issues);
  if (!rows) return {ExitCode::unusable_input, {}};
  Issues issues;
  const std::vector<ControlPoint> points = control_points(*rows, derive_tables(project.state()), file, issues);
  console.issues(issues);
  const Result<ControlReport> report = solve_control_points(points, {});
  console.issues(report.issues);
  if (!report) return {ExitCode::failed, {}};
  say_residuals(*report, console);
  return {ExitCode::done, report->georeference};
}

}  // namespace

ExitCode run_georeference(const GeoreferenceOptions& options, Session& session) {
  std::optional<Project> project = open_project(options.project, session);
  if (!project) return ExitCode::unusable_input;
  Placement placement;
  if (!options.anchor.empty()) placement = by_anchor(options.anchor, session.console);
  if (!options.crs.empty()) placement = by_crs(options.crs, session.console);
  if (!options.control.empty()) placement = by_control_points(options.control, *project, session.console);
  if (placement.code != ExitCode::done) return placement.code;
  project->execute(set_georeference(placement.georeference));
  return save_project(options.project, *project, session);
}

}  // namespace stemwise
