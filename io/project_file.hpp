#pragma once
#include <string>

#include "core/base/result.hpp"
#include "core/project/project_state.hpp"

namespace stemwise {

/// True for a GeoPackage that holds a Stemwise project.
bool is_project(const std::string& path);

/// Writes the whole state as a GeoPackage: map layers (trees, observations, links, coverage; matches and inventories as
/// tables) for any GIS, and tables `stemwise_*` from which the state is read back. The file is replaced only by a complete
/// one. `inventory.frames` are not kept. Time stamps follow SOURCE_DATE_EPOCH where it is set.
Result<Done> write_project(const ProjectState& state, const std::string& path);

/// Reads back exactly what was written. Failure, with what is wrong, when the file is none of ours, is damaged, or is of a
/// newer version.
Result<ProjectState> read_project(const std::string& path);

}  // namespace stemwise
