#include "core/geodesy/azimuth.hpp"

#include <GeographicLib/Geoid.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <GeographicLib/MagneticModel.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cmath>

namespace stemwise {

std::optional<AzimuthKind> azimuth_kind_from(const std::string& word) {
  if (word == "true") return AzimuthKind::true_north;
  if (word == "grid") return AzimuthKind::grid;
  if (word == "magnetic") return AzimuthKind::magnetic;
  return std::nullopt;
}

std::optional<double> utm_convergence_deg(const Geodetic& point) {
  int zone = 0;
  bool north = true;
  double easting = 0.0, northing = 0.0, convergence_deg = 0.0, scale = 0.0;
  try {
    GeographicLib::UTMUPS::Forward(point.latitude_deg, point.longitude_deg, zone, north, easting, northing, convergence_deg, scale);
  } catch (const GeographicLib::GeographicErr&) {
    return std::nullopt;
  }
  if (zone == GeographicLib::UTMUPS::UPS) return std::nullopt;
  return convergence_deg;
}

Result<double> declination_deg(const Geodetic& point, Date day, const std::string& model) {
  const double year = 2000.0 + static_cast<double>(day.days - date_from_civil(2000, 1, 1).days) / 365.25;
  try {
    const GeographicLib::MagneticModel field(model);
    double east = 0.0, north = 0.0, up = 0.0, horizontal = 0.0, total = 0.0, declination = 0.0, inclination = 0.0;
    field(year, point.latitude_deg, point.longitude_deg, point.height_m, east, north, up);
    GeographicLib::MagneticModel::FieldComponents(east, north, up, horizontal, total, declination, inclination);
    if (year < field.MinTime() - 0.5 || year > field.MaxTime() + 0.5)
      return Result<double>::failure(Issue{Severity::error, "", 0, "", "the magnetic model " + model + " does not cover " + to_string(day), "name another with --magnetic-model, or give --declination DEG"});
    return declination;
  } catch (const std::exception& problem) {
    return Result<double>::failure(Issue{Severity::error, "", 0, "", "the magnetic model " + model + " is not on this machine (" + problem.what() + ")",
                                         "give --declination DEG (east is positive), or install the model (geographiclib-get-magnetic " + model + ")"});
  }
}

Geodetic beside(const Geodetic& origin, double east_m, double north_m) {
  const GeographicLib::LocalCartesian plane(origin.latitude_deg, origin.longitude_deg, origin.height_m);
  Geodetic out;
  plane.Reverse(east_m, north_m, 0.0, out.latitude_deg, out.longitude_deg, out.height_m);
  return out;
}

LocalGeoid local_geoid(std::string name, double at_m, double east_m, double north_m) {
  return {std::move(name), at_m, (east_m - at_m) / geoid_step_m, (north_m - at_m) / geoid_step_m};
}

Result<LocalGeoid> local_geoid_of_model(const std::string& name, const Geodetic& origin) {
  try {
    const GeographicLib::Geoid geoid(name);
    const auto height_m = [&](const Geodetic& at) { return geoid(at.latitude_deg, at.longitude_deg); };
    return local_geoid(name, height_m(origin), height_m(beside(origin, geoid_step_m, 0.0)), height_m(beside(origin, 0.0, geoid_step_m)));
  } catch (const std::exception& problem) {
    return Result<LocalGeoid>::failure(Issue{Severity::error, "", 0, "", "the geoid " + name + " is not on this machine (" + problem.what() + ")",
                                             "install it (geographiclib-get-geoids " + name + "), set GEOGRAPHICLIB_GEOID_PATH to its folder, or name a grid file of PROJ (.gtx, .tif)"});
  }
}

}  // namespace stemwise
