#include "app/load_inventories.hpp"

#include <algorithm>

#include "core/survey/build_global_inventory.hpp"

namespace stemwise {

LoadedInventories load_inventories(const std::vector<std::string>& paths, const ReadOverrides& overrides, Session& session,
                                   const Progress& progress) {
  ReadInputs read = read_inputs(paths, overrides, session, progress.stage(0.0, 0.5));
  LoadedInventories loaded;
  session.console.issues(read.usage);
  if (has_error(read.usage)) return {ExitCode::usage, {}, to_string(read.usage.front())};
  for (const ReadInput& input : read.inputs) {
    session.console.issues(input.inventory.issues);
    if (input.inventory) continue;
    loaded.code = ExitCode::unusable_input;
    const auto error = std::find_if(input.inventory.issues.begin(), input.inventory.issues.end(), [](const Issue& i) { return i.severity == Severity::error; });
    if (loaded.problem.empty() && error != input.inventory.issues.end()) loaded.problem = input.name + ": " + error->text;
  }
  if (loaded.code != ExitCode::done) return loaded;
  for (std::size_t i = 0; i < read.inputs.size(); ++i) {
    const auto at = [&](std::size_t n) { return 0.5 + 0.5 * static_cast<double>(n) / static_cast<double>(read.inputs.size()); };
    loaded.inventories.push_back(with_global_stems(std::move(*read.inputs[i].inventory), {}, progress.stage(at(i), at(i + 1))));
  }
  return loaded;
}

}  // namespace stemwise
