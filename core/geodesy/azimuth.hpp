#pragma once
#include <optional>
#include <string>

#include "core/base/date.hpp"
#include "core/base/result.hpp"
#include "core/geodesy/georeference.hpp"

namespace stemwise {

/// From which north an azimuth counts: the meridian, a map's grid lines, or a compass needle.
enum class AzimuthKind { true_north, grid, magnetic };
std::optional<AzimuthKind> azimuth_kind_from(const std::string& word);  ///< "true", "grid", "magnetic"

/// Bearing of UTM's grid north, degrees clockwise from true north, in the zone of the point: true = grid + convergence.
/// Nothing outside UTM.
std::optional<double> utm_convergence_deg(const Geodetic& point);

/// Magnetic declination, degrees east of true north, on a day: true = magnetic + declination. By GeographicLib's
/// MagneticModel ("wmm2020", "igrf13", ...); an error issue when its data is not on this machine or the day is outside it.
Result<double> declination_deg(const Geodetic& point, Date day, const std::string& model);

/// The height of a geoid above the ellipsoid, by GeographicLib's Geoid ("egm2008-5", "egm96-5", ...), as a plane about the
/// point. An error issue when its data is not on this machine.
Result<LocalGeoid> local_geoid_of_model(const std::string& name, const Geodetic& origin);

/// A plane through the geoid's heights at a point and 500 m to the east and to the north of it (m above the ellipsoid).
LocalGeoid local_geoid(std::string name, double at_m, double east_m, double north_m);
/// The points where those heights are taken: at the origin, east of it, north of it.
Geodetic beside(const Geodetic& origin, double east_m, double north_m);
inline constexpr double geoid_step_m = 500.0;

}  // namespace stemwise
