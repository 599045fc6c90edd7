#pragma once
#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/project/project_state.hpp"
#include "io/project_stamp.hpp"

namespace stemwise {

/// True for a GeoPackage that holds a Stemwise project.
bool is_project(const std::string& path);

/// Writes the whole state as a GeoPackage: map layers (trees, observations, links, coverage; matches and inventories as
/// tables) for any GIS, and tables `stemwise_*` from which the state is read back. The file is replaced only by a complete
/// one. `inventory.frames` are not kept. Time stamps follow SOURCE_DATE_EPOCH where it is set. The value is the file's new stamp.
/// `known`: its stamp when it was read or written here last; nothing is written where the file holds something else by now.
Result<ProjectStamp> write_project(const ProjectState& state, const std::string& path, const std::optional<ProjectStamp>& known = std::nullopt);

/// Reads back exactly what was written. Failure, with what is wrong, when the file is none of ours, is damaged, or is of a
/// newer version.
Result<ProjectState> read_project(const std::string& path);

}  // namespace stemwise
