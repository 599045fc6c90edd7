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

/// Turns reference coordinates so that +y points north: the azimuth counts clockwise from north, yaw counter-clockwise.
Eigen::Matrix3d enu_from_reference(const Georeference& anchor) {
  return rotation_from({0.0, 0.0, -radians(anchor.azimuth_deg)});
}

}  // namespace

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
