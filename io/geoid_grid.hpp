#pragma once
#include <string>

#include "core/base/result.hpp"
#include "core/geodesy/georeference.hpp"

namespace stemwise {

/// The height of a geoid above the ellipsoid about a point, from a grid file that PROJ reads (.gtx, .tif; a bare name is looked
/// for where PROJ keeps its data). An error issue when there is no such grid, or it does not cover the point.
Result<LocalGeoid> local_geoid_of_grid(const std::string& file, const Geodetic& origin);
/// Named like a grid file (.gtx, .tif, .gsb), not like a model of GeographicLib.
bool is_geoid_grid(const std::string& name);

/// Bearing of a projected system's grid north, degrees clockwise from true north; nothing where the system has no place for the point.
std::optional<double> grid_convergence_deg(int epsg, const Geodetic& point);

}  // namespace stemwise
