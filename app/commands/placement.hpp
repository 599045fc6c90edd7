#pragma once
#include <string>
#include <vector>

#include "app/commands/georeference.hpp"
#include "core/project/project_state.hpp"
#include "io/read_control_points.hpp"

namespace stemwise {

/// What placing a project came to: a georeference, or how the command ends; and what there is to say about it.
struct Placement {
  ExitCode code = ExitCode::done;
  Georeference georeference;
  std::vector<Eigen::Vector3d> places_m;  ///< of the control points in the reference's frame, in the order of the residuals
  std::vector<std::string> said;  ///< residuals and the fit's quality, a line each
  Issues issues;
};

/// Where the project lies on the earth by what the options name: anchor, CRS, track or control points, with the geoid. `typed`:
/// control points beside those of the file.
Placement place_project(const GeoreferenceOptions& options, const ProjectState& state, const std::vector<ControlRow>& typed = {});
/// The coordinates of `inventory` taken as those of a projected system; refused where that system is not used.
Placement place_in_crs(int epsg, const Inventory& inventory);
void tell(const Placement& placement, Console& console);

}  // namespace stemwise
