#include "app/commands/open_project.hpp"

#include "io/project_file.hpp"

namespace stemwise {

std::optional<Project> open_project(const std::string& path, Session& session) {
  Result<ProjectState> read = read_project(path);
  session.console.issues(read.issues);
  if (!read) return std::nullopt;
  return Project(std::move(*read));
}

ExitCode save_project(const std::string& path, const Project& project, Session& session) {
  const Result<Done> written = write_project(project.state(), path);
  session.console.issues(written.issues);
  return written ? ExitCode::done : ExitCode::failed;
}

}  // namespace stemwise
