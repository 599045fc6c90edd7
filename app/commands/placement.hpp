#pragma once
#include "app/commands/georeference.hpp"
#include "core/base/result.hpp"
#include "core/project/project_state.hpp"

namespace stemwise {

/// What placing a project came to: a georeference, or how the command ends.
struct Placement {
  ExitCode code = ExitCode::done;
  Georeference georeference;
};

Placement place_by_anchor(const GeoreferenceOptions& options, const ProjectState& state, Console& console);
Placement place_by_crs(const GeoreferenceOptions& options, const ProjectState& state, Console& console);
Placement place_by_control_points(const GeoreferenceOptions& options, const ProjectState& state, Console& console);
Placement place_by_gnss(const GeoreferenceOptions& options, const ProjectState& state, Console& console);

/// The coordinates of `inventory` taken as those of a projected system; refused (and told) where that system is not used.
Placement place_in_crs(int epsg, const Inventory& inventory, Console& console);

Placement placement_refused(Console& console, ExitCode code, const std::string& text);
/// The geoid that --geoid names, about a place: GeographicLib's model of that name, or PROJ's grid. No name: no geoid.
Result<LocalGeoid> named_geoid(const std::string& name, const Geodetic& origin);
/// The azimuth in degrees clockwise from true north, whichever north the person counted from.
Result<double> true_azimuth_deg(double azimuth_deg, const GeoreferenceOptions& options, const ProjectState& state, const Geodetic& at);

}  // namespace stemwise
