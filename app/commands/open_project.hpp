#pragma once
#include <optional>
#include <string>

#include "app/session.hpp"
#include "core/project/project.hpp"
#include "io/project_stamp.hpp"

namespace stemwise {

/// A project that a command works on, and what its file held when it was read.
struct OpenedProject {
  Project project;
  std::string path;
  ProjectStamp stamp;
};

/// Reads a project and says every issue; nothing when it cannot be used (the caller exits with unusable_input).
std::optional<OpenedProject> open_project(const std::string& path, Session& session);
/// Writes it back, unless its own file was changed by a window or another command in the meantime; says why not.
ExitCode save_project(const std::string& path, const OpenedProject& opened, Session& session);

}  // namespace stemwise
