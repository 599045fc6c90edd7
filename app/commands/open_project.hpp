#pragma once
#include <optional>
#include <string>

#include "app/session.hpp"
#include "core/project/project.hpp"

namespace stemwise {

/// Reads a project and says every issue; nothing when it cannot be used (the caller exits with unusable_input).
std::optional<Project> open_project(const std::string& path, Session& session);
/// Writes it back; says why not.
ExitCode save_project(const std::string& path, const Project& project, Session& session);

}  // namespace stemwise
