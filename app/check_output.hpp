#pragma once
#include <string>
#include <vector>

#include "app/console.hpp"
#include "app/exit_code.hpp"

namespace stemwise {

enum class OutputKind { project, other };

/// Before any work, what would only be noticed after it, or destroy what is read: a folder that is not there (failed), an
/// output that is one of the inputs or a Stemwise project which the command does not write, a project that is no .gpkg
/// (usage). Says why. A project that is read may be written again.
ExitCode check_output(const std::string& output, OutputKind kind, const std::vector<std::string>& inputs, Console& console);

}  // namespace stemwise
