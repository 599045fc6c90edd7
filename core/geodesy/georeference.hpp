#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

namespace stemwise {

/// WGS 84, degrees, metres above the ellipsoid unless a geoid was named.
struct Geodetic {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double height_m = 0.0;
  bool operator==(const Geodetic&) const = default;
};

enum class GeoreferenceKind { none, anchor, crs };

/// Where the reference's frame lies on the earth. `anchor`: the position of one of its points (its origin unless
/// `anchored_point_m` says otherwise) and the direction of its +y axis (degrees clockwise from true north); the frame is
/// level there. `crs`: its coordinates are already those of `epsg`.
struct Georeference {
  GeoreferenceKind kind = GeoreferenceKind::none;
  Geodetic origin;
  Eigen::Vector3d anchored_point_m = Eigen::Vector3d::Zero();  ///< in the reference's frame: what lies at `origin`
  double azimuth_deg = 0.0;
  int epsg = 0;           ///< of the coordinates for `crs`
  double sd_m = 0.0;      ///< planar uncertainty, 0 when nothing is known
  std::string method;     ///< "anchor", "control points (4)", "CRS of 2019.gpkg": for people
  bool operator==(const Georeference&) const = default;
};

/// The anchor's tangent plane, by GeographicLib's LocalCartesian. Only for `anchor`.
Geodetic geodetic_from_reference(const Georeference& anchor, const Eigen::Vector3d& point_in_reference_m);
Eigen::Vector3d reference_from_geodetic(const Georeference& anchor, const Geodetic& point);

/// A position in its UTM zone (zone 1..60).
struct UtmPosition {
  int zone = 0;
  bool north = true;
  double easting_m = 0.0;
  double northing_m = 0.0;
  int epsg() const { return (north ? 32600 : 32700) + zone; }
};
/// In the zone of `zone_of` (one zone for a whole project, also across its edge). Nothing outside UTM (poles).
std::optional<UtmPosition> utm_from_geodetic(const Geodetic& point, const Geodetic& zone_of);

}  // namespace stemwise
