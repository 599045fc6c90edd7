#include "app/check_output.hpp"
#include "app/commands/open_project.hpp"
#include "app/commands/project_commands.hpp"
#include "app/result_json.hpp"
#include "core/project/commands.hpp"

namespace stemwise {

ExitCode run_remove(const RemoveOptions& options, Session& session) {
  const std::string& output = options.output.empty() ? options.project : options.output;
  if (const ExitCode code = check_output(output, OutputKind::project, {options.project}, session.console); code != ExitCode::done) return code;
  std::optional<OpenedProject> opened = open_project(options.project, session);
  if (!opened) return ExitCode::unusable_input;
  for (const std::string& name : options.inventories) {
    const auto inventory = opened->project.state().find(name);
    if (!inventory) {
      session.console.error(options.project + ": there is no survey " + name);
      return ExitCode::usage;
    }
    if (inventory->id == opened->project.state().reference) {
      session.console.error(name + " is the reference, in whose frame all others lie: align the others anew without it");
      return ExitCode::usage;
    }
    opened->project.execute(remove_inventory(inventory->id));
  }
  if (const ExitCode saved = save_project(output, *opened, session); saved != ExitCode::done) return saved;
  session.console.say(output + ": " + std::to_string(opened->project.state().inventories.size()) + " surveys, " + std::to_string(opened->project.state().trees.size()) + " trees");
  return session.write_json(result_json({{"output", output}, {"removed", options.inventories}, {"trees", static_cast<std::int64_t>(opened->project.state().trees.size())}}));
}

}  // namespace stemwise
