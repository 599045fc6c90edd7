#include "app/commands/georeference.hpp"

#include <nlohmann/json.hpp>

#include "app/commands/open_project.hpp"
#include "app/commands/placement.hpp"
#include "core/geodesy/azimuth.hpp"
#include "core/project/commands.hpp"

namespace stemwise {
namespace {

/// Options that contradict each other, before anything is read; "" when they do not.
std::string contradiction(const GeoreferenceOptions& options) {
  if (!azimuth_kind_from(options.azimuth_kind)) return "--azimuth-kind " + options.azimuth_kind + ": expected true, grid or magnetic";
  if (options.translation_only && options.control.empty()) return "--translation-only goes with --control";
  if (options.translation_only != options.azimuth_deg.has_value()) return "--translation-only and --azimuth go together: the one keeps what the other gives";
  if (options.level && options.tilted) return "--level and --tilted exclude each other";
  if (options.declination_deg && options.azimuth_kind != "magnetic") return "--declination goes with --azimuth-kind magnetic";
  return "";
}

std::string georeference_json(const Georeference& g) {
  using nlohmann::ordered_json;
  ordered_json json{{"method", g.method}};
  if (g.kind == GeoreferenceKind::crs) json["epsg"] = g.epsg;
  json["origin"] = {{"lat", g.origin.latitude_deg}, {"lon", g.origin.longitude_deg}, {"height_above_ellipsoid_m", g.origin.height_m}};
  json["anchored_point_m"] = {g.anchored_point_m.x(), g.anchored_point_m.y(), g.anchored_point_m.z()};
  if (g.kind == GeoreferenceKind::anchor) {
    json["azimuth_deg"] = g.azimuth_deg;
    json["azimuth_sd_deg"] = g.azimuth_sd_deg;
    json["roll_deg"] = g.roll_deg;
    json["pitch_deg"] = g.pitch_deg;
  }
  json["sd_m"] = g.sd_m;
  json["heights"] = g.geoid.name.empty() ? "ellipsoid" : g.geoid.name;
  if (!g.geoid.name.empty()) json["geoid_height_m"] = g.geoid.height_m;
  json["residuals"] = ordered_json::array();
  for (const ControlResidual& r : g.residuals)
    json["residuals"].push_back({{"name", r.name}, {"residual_m", r.residual_m}, {"leave_one_out_m", r.leave_one_out_m ? ordered_json(*r.leave_one_out_m) : ordered_json()}, {"used", r.used}});
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace

ExitCode run_georeference(const GeoreferenceOptions& options, Session& session) {
  if (const std::string problem = contradiction(options); !problem.empty()) {
    session.console.error(problem);
    return ExitCode::usage;
  }
  std::optional<OpenedProject> opened = open_project(options.project, session);
  if (!opened) return ExitCode::unusable_input;
  const Placement placement = place_project(options, opened->project.state());
  tell(placement, session.console);
  if (placement.code != ExitCode::done) return placement.code;
  opened->project.execute(set_georeference(placement.georeference));
  const ExitCode saved = save_project(options.project, *opened, session);
  if (saved != ExitCode::done) return saved;
  session.console.say(options.project + ": placed on the earth by " + placement.georeference.method);
  return session.write_json(georeference_json(placement.georeference));
}

}  // namespace stemwise
