#include "app/commands/align.hpp"

#include <filesystem>

#include "app/align_json.hpp"
#include "app/align_run.hpp"
#include "io/project_file.hpp"

namespace stemwise {
namespace {

/// Before the work, what would only be noticed after it.
ExitCode check_output(const std::string& path, Console& console) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  std::error_code code;
  if (std::filesystem::is_directory(folder, code)) return ExitCode::done;
  console.error(path + ": cannot be written, there is no folder " + folder.string());
  return ExitCode::failed;
}

}  // namespace

ExitCode run_align(const AlignOptions& options, Session& session) {
  if (const ExitCode code = check_output(options.output, session.console); code != ExitCode::done) return code;
  const AlignRun run = run_alignment(options, session);
  if (run.code != ExitCode::done) return run.code;
  session.progress().check();
  const ProjectState& state = run.project.state();
  const ExitCode verdict = judge_alignment(state, session.console);
  if (verdict == ExitCode::done) {
    const Result<Done> written = write_project(state, options.output);
    session.console.issues(written.issues);
    if (!written) return ExitCode::failed;
  }
  session.console.say(align_text(state, run.tables));
  const ExitCode json = session.write_json(align_json(state, run.tables, run.timing, run.seed));
  return verdict != ExitCode::done ? verdict : json;
}

}  // namespace stemwise
