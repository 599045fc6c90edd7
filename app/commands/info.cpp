#include "app/commands/info.hpp"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/inventory_summary.hpp"
#include "app/commands/project_summary.hpp"
#include "io/project_file.hpp"

namespace stemwise {

namespace {

/// Says what a project holds; false when it cannot be read.
bool describe_project(const std::string& path, Session& session, nlohmann::ordered_json& projects) {
  const Result<ProjectState> state = read_project(path);
  session.console.issues(state.issues);
  if (!state) return false;
  if (session.common.json != "-") std::cout << project_text(path, *state) << std::flush;
  projects.push_back(project_json(path, *state));
  return true;
}

}  // namespace

ExitCode run_info(const InfoOptions& options, Session& session) {
  std::vector<std::string> inventories;
  nlohmann::ordered_json projects = nlohmann::ordered_json::array();
  bool readable = true;
  for (const std::string& path : options.paths) {
    if (is_project(path)) readable = describe_project(path, session, projects) && readable;
    else inventories.push_back(path);
  }
  const ReadInputs read = read_inputs(inventories, options.read, session, session.progress());
  session.console.end_progress();
  session.console.issues(read.usage);
  if (has_error(read.usage)) return ExitCode::usage;
  for (const ReadInput& input : read.inputs) {
    if (session.common.json != "-") std::cout << info_text(input) << std::flush;
    session.console.issues(input.inventory.issues);
  }
  const ExitCode written = session.write_json(info_json(read.inputs, projects));
  if (written != ExitCode::done) return written;
  const bool all_usable = std::all_of(read.inputs.begin(), read.inputs.end(), [](const ReadInput& i) { return bool(i.inventory); });
  return all_usable && readable ? ExitCode::done : ExitCode::unusable_input;
}

}  // namespace stemwise
