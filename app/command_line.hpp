#pragma once
#include <string>
#include <vector>

#include "app/exit_code.hpp"

namespace stemwise {

/// Reads the command line (without the program's name), runs the command and returns what the process exits with.
/// Text for people goes to stderr, results and --help to stdout.
ExitCode run_command_line(const std::vector<std::string>& arguments);

}  // namespace stemwise
