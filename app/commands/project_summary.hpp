#pragma once
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/project/project_state.hpp"

namespace stemwise {

/// What a project holds: its inventories with status and quality, trees by fate, decisions, georeference, rules; for people.
std::string project_text(const std::string& path, const ProjectState& state);
/// The same for `info --json`.
nlohmann::ordered_json project_json(const std::string& path, const ProjectState& state);

}  // namespace stemwise
