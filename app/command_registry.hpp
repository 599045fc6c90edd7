#pragma once
#include <functional>

#include "app/session.hpp"

namespace CLI {
class App;
}

namespace stemwise {

/// What the command line chose to run, filled by the callback of the chosen subcommand.
struct ChosenCommand {
  std::function<ExitCode(Session&)> run;
};

/// One more subcommand with the common options on it. Internal to the files that build the command line (command_line*.cpp,
/// the only ones that see CLI11).
CLI::App& add_command(CLI::App& root, CommonOptions& common, const char* name, const char* description);

// Each adds its group of subcommands; command_line.cpp calls them in the order of cli.md.
void add_window_command(CLI::App& root, CommonOptions& common, ChosenCommand& chosen);
void add_reading_commands(CLI::App& root, CommonOptions& common, ChosenCommand& chosen);
void add_project_commands(CLI::App& root, CommonOptions& common, ChosenCommand& chosen);
void add_evaluate_commands(CLI::App& root, CommonOptions& common, ChosenCommand& chosen);

}  // namespace stemwise
