#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace stemwise {

/// WGS 84, degrees, metres above the ellipsoid unless a geoid was named.
struct Geodetic {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double height_m = 0.0;
  bool operator==(const Geodetic&) const = default;
};

enum class GeoreferenceKind { none, anchor, crs };

/// One control point or stretch of a track, after the fit.
struct ControlResidual {
  std::string name;
  double residual_m = 0.0;                ///< planar, against the fit of all
  std::optional<double> leave_one_out_m;  ///< planar, against the fit of the others; needs one point more than the fit
  bool used = true;
  bool operator==(const ControlResidual&) const = default;
};

/// A geoid near the georeference's origin, as a plane: exact to millimetres over the kilometres of a forest.
struct LocalGeoid {
  std::string name;                 ///< "egm2008-5", a grid's file name; empty: heights are ellipsoidal
  double height_m = 0.0;            ///< of the geoid above the ellipsoid, at the origin
  double slope_east = 0.0;          ///< metres per metre
  double slope_north = 0.0;
  bool operator==(const LocalGeoid&) const = default;
};

/// Where the reference's frame lies on the earth. `anchor`: the position of one of its points (its origin unless
/// `anchored_point_m` says otherwise) and the direction of its +y axis (degrees clockwise from true north); the frame is
/// level there but for `roll_deg` and `pitch_deg`. `crs`: its coordinates are already those of `epsg`.
struct Georeference {
  GeoreferenceKind kind = GeoreferenceKind::none;
  Geodetic origin;                                               ///< height above the ellipsoid, always
  Eigen::Vector3d anchored_point_m = Eigen::Vector3d::Zero();  ///< in the reference's frame: what lies at `origin`
  double azimuth_deg = 0.0;
  int epsg = 0;           ///< of the coordinates for `crs`
  double sd_m = 0.0;      ///< planar uncertainty of the anchored point, one axis; 0 when nothing is known
  std::string method;     ///< "anchor", "control points (4)", "CRS of 2019.gpkg": for people
  double roll_deg = 0.0;  ///< of a frame that is not level: enu = Rz(-azimuth) Ry(pitch) Rx(roll) * frame
  double pitch_deg = 0.0;
  double azimuth_sd_deg = 0.0;  ///< 0 when nothing is known
  LocalGeoid geoid;       ///< whose heights are given out
  std::vector<ControlResidual> residuals;  ///< of the control points or the track it comes from
  bool operator==(const Georeference&) const = default;
};

/// The anchor's tangent plane, by GeographicLib's LocalCartesian. Only for `anchor`.
Geodetic geodetic_from_reference(const Georeference& anchor, const Eigen::Vector3d& point_in_reference_m);
Eigen::Vector3d reference_from_geodetic(const Georeference& anchor, const Geodetic& point);
/// Turns reference coordinates so that +x points east, +y true north and +z up. Only for `anchor`.
Eigen::Matrix3d enu_from_reference(const Georeference& anchor);

/// Height of the named geoid above the ellipsoid at a point near the origin; 0 without one.
double geoid_height_m(const Georeference& georeference, const Geodetic& point);
/// Planar uncertainty on the earth (one axis, m) of a point known to `sd_in_reference_m` in the reference's frame: with the
/// anchored point's own and the azimuth's, which grows with the distance from it.
double position_sd_on_earth_m(const Georeference& georeference, const Eigen::Vector3d& point_in_reference_m, double sd_in_reference_m);

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
