#pragma once
#include <string>
#include <vector>

#include "app/console.hpp"
#include "app/exit_code.hpp"
#include "app/session.hpp"
#include "core/project/project_state.hpp"

namespace stemwise {

enum class OutputKind { project, other };

/// Before any work, what would only be noticed after it, or destroy what is read: a folder that is not there (failed), an
/// output that is one of the inputs or a Stemwise project which the command does not write, a project that is no .gpkg
/// (usage). Says why. A project that is read may be written again.
ExitCode check_output(const std::string& output, OutputKind kind, const std::vector<std::string>& inputs, Console& console);

/// An output that is one of the files that the project's surveys were read from (usage).
ExitCode check_no_source(const std::string& output, const ProjectState& state, Console& console);

/// Before any work: the name of an output must end in one of the suffixes that `what` is written in (usage).
ExitCode check_suffix(const std::string& output, const std::vector<std::string>& suffixes, const std::string& what, Console& console);

/// Before any work: where --json may not write. A file that holds anything but an earlier result would be destroyed, and so would
/// one that another of the words of the command line names (usage).
ExitCode check_json_target(const std::string& path, const std::vector<std::string>& words, Console& console);

/// Before any work: where a table of results (`option`, empty or "-" too) may be written: to a new file, or over an earlier table, which begins
/// with `head`; never into a folder that is read, and not to stdout beside --json - (usage; failed where there is no folder).
ExitCode check_table_target(const std::string& option, const std::string& path, const std::string& head, const std::vector<std::string>& inputs,
                            const CommonOptions& common, Console& console);

/// A project that would be written anew and not be read: the decisions that people made in it would be gone (usage).
ExitCode check_decisions_kept(const std::string& project, Console& console);

}  // namespace stemwise
