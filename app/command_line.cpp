#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/check_output.hpp"
#include "app/command_registry.hpp"
#include "app/interrupt.hpp"
#include "core/base/parallel.hpp"

namespace stemwise {
namespace {

constexpr const char* description =
    "Stemwise aligns stem lists of the same forest from several years, without GNSS or a first guess, and tells which\n"
    "stem is which and how it grew.";
constexpr const char* exit_codes =
    "Exit codes: 0 done, 1 the work failed, 2 bad usage, 3 an input has no usable row, 130 interrupted.";

bool is_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  return error == std::errc{} && end == text.data() + text.size();
}

void add_common(CLI::App& app, CommonOptions& common) {
  app.add_option("--threads", common.threads, "Threads to use; the result does not depend on it (default: all)")
      ->check(CLI::Range(1, 4096))
      ->group("Common");
  app.add_option("--seed", common.seed, "Seed of everything random (default 0)")
      ->check([](const std::string& text) { return is_seed(text) ? std::string() : "expected a whole number from 0 to 18446744073709551615, not " + text; })
      ->group("Common");
  app.add_option("--config", common.config, "JSON file of settings by their keys")->group("Common");
  app.add_option("--set", common.settings, "One setting, key=value; may be given again")->allow_extra_args(false)->group("Common");
  app.add_option("--json", common.json, "Write the machine-readable result to this file, - for stdout")->group("Common");
  app.add_flag("--quiet,-q", common.quiet, "Say nothing but errors")->group("Common");
}

/// CLI11's own exit codes are its affair; ours are 0 for help and version, 2 for everything it refuses.
ExitCode report_parse_outcome(const CLI::App& app, const CLI::ParseError& outcome) {
  if (outcome.get_exit_code() == 0) {
    app.exit(outcome, std::cout, std::cerr);
    return ExitCode::done;
  }
  const CLI::App* where = &app;
  for (auto parsed = app.get_subcommands(); !parsed.empty(); parsed = where->get_subcommands()) where = parsed.back();
  std::cerr << "error: " << outcome.what() << "\n";
  std::cerr << "Run stemwise " << (where == &app ? "" : where->get_name() + " ") << "--help for what it takes.\n";
  return ExitCode::usage;
}

ExitCode run_chosen(const ChosenCommand& chosen, const CommonOptions& common, const std::vector<std::string>& words, const Interrupt& interrupt) {
  Console console(common.quiet);
  Session session{common, console, interrupt.requested()};
  if (const ExitCode code = check_json_target(common.json, words, console); code != ExitCode::done) return code;
  try {
    return chosen.run(session);
  } catch (const Cancelled&) {
    console.error("interrupted; no half-written file was left");
    return ExitCode::interrupted;
  } catch (const std::bad_alloc&) {
    console.error("out of memory");
  } catch (const std::exception& e) {  // a programmer's error: bad input never gets here
    console.error(std::string("internal error: ") + e.what());
  }
  return ExitCode::failed;
}

bool is_command(const CLI::App& root, const std::string& word) {
  const auto commands = root.get_subcommands([&](const CLI::App* command) { return command->get_name() == word; });
  return !commands.empty();
}

/// A first word that is neither an option, nor a command, nor a file: a mistyped command, most likely.
bool means_nothing(const std::vector<std::string>& arguments, const CLI::App& root) {
  return !arguments.empty() && !arguments.front().starts_with("-") && !is_command(root, arguments.front()) &&
         !std::filesystem::exists(arguments.front());
}

/// `stemwise [FILE...]` is `stemwise gui [FILE...]`.
std::vector<std::string> with_command(std::vector<std::string> arguments, const CLI::App& root) {
  const bool opens_files = !arguments.empty() && !arguments.front().starts_with("-") && !is_command(root, arguments.front()) &&
                           std::filesystem::exists(arguments.front());
  if (arguments.empty() || opens_files) arguments.insert(arguments.begin(), "gui");
  return arguments;
}

}  // namespace

CLI::App& add_command(CLI::App& root, CommonOptions& common, const char* name, const char* what) {
  CLI::App& command = *root.add_subcommand(name, what);
  add_common(command, common);
  command.footer(exit_codes);
  return command;
}

ExitCode run_command_line(const std::vector<std::string>& arguments) {
  const Interrupt interrupt;
  CommonOptions common;
  ChosenCommand chosen;
  CLI::App root(description, "stemwise");
  root.set_version_flag("--version", std::string("stemwise ") + STEMWISE_VERSION);
  root.footer(exit_codes);
  add_common(root, common);
  add_window_command(root, common, chosen);
  add_reading_commands(root, common, chosen);
  add_project_commands(root, common, chosen);
  add_evaluate_commands(root, common, chosen);
  root.require_subcommand(1);
  if (means_nothing(arguments, root)) {
    std::cerr << "error: '" << arguments.front() << "' is neither a command nor a file\nRun stemwise --help for what it takes.\n";
    return ExitCode::usage;
  }
  try {
    const std::vector<std::string> given = with_command(arguments, root);
    root.parse(std::vector<std::string>(given.rbegin(), given.rend()));
  } catch (const CLI::ParseError& outcome) {
    return report_parse_outcome(root, outcome);
  }
  return run_chosen(chosen, common, arguments, interrupt);
}

}  // namespace stemwise
