#include "app/commands/convert.hpp"

#include "app/check_output.hpp"
#include "app/load_inventories.hpp"
#include "app/result_json.hpp"
#include "io/write_inventory.hpp"

namespace stemwise {

ExitCode run_convert(const ConvertOptions& options, Session& session) {
  if (const ExitCode code = check_suffix(options.output, inventory_suffixes(), "an inventory (or a folder of frames, whose name has no suffix)", session.console); code != ExitCode::done) return code;
  if (const ExitCode code = check_output(options.output, OutputKind::other, {options.input}, session.console); code != ExitCode::done) return code;
  LoadedInventories loaded = load_inventories({options.input}, options.read, session, session.progress());
  session.console.end_progress();
  if (loaded.code != ExitCode::done) return loaded.code;
  const Result<Done> written = write_inventory(options.output, loaded.inventories.front());
  session.console.issues(written.issues);
  if (!written) return ExitCode::failed;
  const std::size_t stems = loaded.inventories.front().stems.size();
  session.console.say(options.output + ": " + std::to_string(stems) + " stems");
  return session.write_json(result_json({{"output", options.output}, {"stems", static_cast<std::int64_t>(stems)}}));
}

}  // namespace stemwise
