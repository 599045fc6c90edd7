#include "app/commands/open_project.hpp"
#include "app/commands/project_commands.hpp"
#include "app/result_json.hpp"
#include "core/project/commands.hpp"

namespace stemwise {

ExitCode run_merge(const MergeOptions& options, Session& session) {
  const std::optional<FusionPolicy> policy = fusion_policy_from(options.policy);
  if (!policy) {
    session.console.error("--policy " + options.policy + ": expected min-dbh, newest, best or mean");
    return ExitCode::usage;
  }
  std::optional<OpenedProject> opened = open_project(options.project, session);
  if (!opened) return ExitCode::unusable_input;
  opened->project.execute(set_fusion_policy(*policy));
  if (const ExitCode saved = save_project(options.project, *opened, session); saved != ExitCode::done) return saved;
  session.console.say(options.project + ": " + std::to_string(opened->project.state().trees.size()) + " trees merged by the policy " + to_string(*policy));
  return session.write_json(result_json({{"output", options.project}, {"policy", to_string(*policy)}, {"trees", static_cast<std::int64_t>(opened->project.state().trees.size())}}));
}

}  // namespace stemwise
