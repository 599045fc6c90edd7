#include "app/commands/info.hpp"

#include <algorithm>
#include <iostream>

#include "app/commands/inventory_summary.hpp"

namespace stemwise {

ExitCode run_info(const InfoOptions& options, Session& session) {
  const ReadInputs read = read_inputs(options.paths, options.read, session, session.progress());
  session.console.end_progress();
  session.console.issues(read.usage);
  if (has_error(read.usage)) return ExitCode::usage;
  for (const ReadInput& input : read.inputs) {
    if (session.common.json != "-") std::cout << info_text(input) << std::flush;
    session.console.issues(input.inventory.issues);
  }
  const ExitCode written = session.write_json(info_json(read.inputs));
  if (written != ExitCode::done) return written;
  const bool all_usable = std::all_of(read.inputs.begin(), read.inputs.end(), [](const ReadInput& i) { return bool(i.inventory); });
  return all_usable ? ExitCode::done : ExitCode::unusable_input;
}

}  // namespace stemwise
