#include "app/commands/open_project.hpp"
#include "app/commands/project_commands.hpp"
#include "core/project/commands.hpp"

namespace stemwise {

ExitCode run_merge(const MergeOptions& options, Session& session) {
  const std::optional<FusionPolicy> policy = fusion_policy_from(options.policy);
  if (!policy) {
    session.console.error("--policy " + options.policy + ": expected min-dbh, newest, best or mean");
    return ExitCode::usage;
  }
  std::optional<Project> project = open_project(options.project, session);
  if (!project) return ExitCode::unusable_input;
  project->execute(set_fusion_policy(*policy));
  return save_project(options.project, *project, session);
}

}  // namespace stemwise
