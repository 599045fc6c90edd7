#include "core/geodesy/georeference.hpp"

#include <GeographicLib/LocalCartesian.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cmath>

#include "core/geometry/rigid_transform.hpp"

namespace stemwise {
namespace {

GeographicLib::LocalCartesian tangent_plane(const Georeference& anchor) {
  return {anchor.origin.latitude_deg, anchor.origin.longitude_deg, anchor.origin.height_m};
}

}  // namespace

// The azimuth counts clockwise from north, yaw counter-clockwise.
Eigen::Matrix3d enu_from_reference(const Georeference& anchor) {
  return rotation_from({radians(anchor.roll_deg), radians(anchor.pitch_deg), -radians(anchor.azimuth_deg)});
}

Geodetic geodetic_from_reference(const Georeference& anchor, const Eigen::Vector3d& point_in_reference_m) {
  const Eigen::Vector3d enu = enu_from_reference(anchor) * (point_in_reference_m - anchor.anchored_point_m);
  Geodetic out;
  tangent_plane(anchor).Reverse(enu.x(), enu.y(), enu.z(), out.latitude_deg, out.longitude_deg, out.height_m);
  return out;
}

Eigen::Vector3d reference_from_geodetic(const Georeference& anchor, const Geodetic& point) {
  Eigen::Vector3d enu;
  tangent_plane(anchor).Forward(point.latitude_deg, point.longitude_deg, point.height_m, enu.x(), enu.y(), enu.z());
  return enu_from_reference(anchor).transpose() * enu + anchor.anchored_point_m;
}

double geoid_height_m(const Georeference& georeference, const Geodetic& point) {
  const LocalGeoid& geoid = georeference.geoid;
  if (geoid.name.empty()) return 0.0;
  double east_m = 0.0, north_m = 0.0, up_m = 0.0;
  tangent_plane(georeference).Forward(point.latitude_deg, point.longitude_deg, georeference.origin.height_m, east_m, north_m, up_m);
  return geoid.height_m + geoid.slope_east * east_m + geoid.slope_north * north_m;
}

double position_sd_on_earth_m(const Georeference& georeference, const Eigen::Vector3d& point_in_reference_m, double sd_in_reference_m) {
  if (georeference.kind == GeoreferenceKind::none) return sd_in_reference_m;
  double turned_m = 0.0;
  if (georeference.kind == GeoreferenceKind::anchor) {
    // An error of the azimuth moves a point across its direction from the anchor: half of its square falls on one axis.
    const double distance_m = (point_in_reference_m - georeference.anchored_point_m).head<2>().norm();
    turned_m = distance_m * radians(georeference.azimuth_sd_deg) * std::sqrt(0.5);
  }
  return std::sqrt(sd_in_reference_m * sd_in_reference_m + georeference.sd_m * georeference.sd_m + turned_m * turned_m);
}

std::optional<UtmPosition> utm_from_geodetic(const Geodetic& point, const Geodetic& zone_of) {
  const int zone = GeographicLib::UTMUPS::StandardZone(zone_of.latitude_deg, zone_of.longitude_deg);
  if (zone < 1 || zone > 60) return std::nullopt;
  UtmPosition out;
  try {
    GeographicLib::UTMUPS::Forward(point.latitude_deg, point.longitude_deg, out.zone, out.north, out.easting_m, out.northing_m, zone);
  } catch (const GeographicLib::GeographicErr&) {
    return std::nullopt;  // further from the zone than UTM reaches
  }
  const bool project_north = zone_of.latitude_deg >= 0.0;
  if (out.north != project_north) {  // one hemisphere for a whole project, also where it crosses the equator
    out.northing_m += project_north ? -10'000'000.0 : 10'000'000.0;
    out.north = project_north;
  }
  return out;
}

}  // namespace stemwise
