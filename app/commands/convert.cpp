#include "app/commands/convert.hpp"

#include <filesystem>

#include "app/load_inventories.hpp"
#include "io/write_inventory.hpp"

namespace stemwise {

ExitCode run_convert(const ConvertOptions& options, Session& session) {
  LoadedInventories loaded = load_inventories({options.input}, options.read, session, session.progress());
  session.console.end_progress();
  if (loaded.code != ExitCode::done) return loaded.code;
  const Result<Done> written = write_inventory(options.output, loaded.inventories.front());
  session.console.issues(written.issues);
  if (written) session.console.say(options.output + ": " + std::to_string(loaded.inventories.front().stems.size()) + " stems");
  return written ? ExitCode::done : ExitCode::failed;
}

}  // namespace stemwise
