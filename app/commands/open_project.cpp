#include "app/commands/open_project.hpp"

#include "io/project_file.hpp"
#include "io/same_file.hpp"

namespace stemwise {

std::optional<OpenedProject> open_project(const std::string& path, Session& session) {
  ProjectStamp stamp = project_stamp(path);
  Result<ProjectState> read = read_project(path);
  session.console.issues(read.issues);
  if (!read) return std::nullopt;
  return OpenedProject{Project(std::move(*read)), path, std::move(stamp)};
}

ExitCode save_project(const std::string& path, const OpenedProject& opened, Session& session) {
  const auto written = write_project(opened.project.state(), path, names_same_file(path, opened.path) ? std::optional(opened.stamp) : std::nullopt);
  session.console.issues(written.issues);
  return written ? ExitCode::done : ExitCode::failed;
}

}  // namespace stemwise
