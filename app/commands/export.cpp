#include "app/commands/export.hpp"

#include <cctype>
#include <cstring>

#include "app/check_output.hpp"
#include "app/commands/open_project.hpp"
#include "app/result_json.hpp"
#include "io/crs.hpp"
#include "io/export_layer.hpp"

namespace stemwise {
namespace {

/// Not what numbers, words and quoted fields are made of.
bool can_delimit(char c) { return c == '\t' || (std::ispunct(static_cast<unsigned char>(c)) != 0 && std::strchr("\"'.-+_", c) == nullptr) || c == ' '; }

/// What the options mean; nothing, after having said why, when they mean nothing.
std::optional<ExportOptions> export_options(const ExportCommandOptions& given, Console& console) {
  ExportOptions options;
  options.decimal_comma = given.decimal_comma;
  options.software = "Stemwise " STEMWISE_VERSION;
  if (!given.layer.empty()) {
    options.layer = layer_kind_from(given.layer);
    if (!options.layer) {
      console.error("--layer " + given.layer + ": expected trees, observations, matches, links, inventories, coverage or forestgeo");
      return std::nullopt;
    }
  }
  if (!given.crs.empty()) {
    options.epsg = epsg_from(given.crs);
    if (!options.epsg || !is_known_epsg(*options.epsg)) {
      console.error("--crs " + given.crs + ": expected EPSG:N of a system that there is, for example EPSG:25832");
      return std::nullopt;
    }
  }
  if (given.delimiter == "tab" || given.delimiter == "\\t") {
    options.delimiter = '\t';
  } else if (given.delimiter.size() == 1 && can_delimit(given.delimiter.front())) {
    options.delimiter = given.delimiter.front();
  } else if (!given.delimiter.empty()) {
    console.error("--delimiter " + given.delimiter + ": expected one character that stands in no number, word or quote, such as ; or | or a comma, or tab");
    return std::nullopt;
  }
  return options;
}

}  // namespace

ExitCode run_export(const ExportCommandOptions& given, Session& session) {
  const std::optional<ExportOptions> options = export_options(given, session.console);
  if (!options) return ExitCode::usage;
  if (const ExitCode code = check_suffix(given.output, export_suffixes(), "an export", session.console); code != ExitCode::done) return code;
  if (const ExitCode code = check_output(given.output, OutputKind::other, {given.project}, session.console); code != ExitCode::done) return code;
  const std::optional<OpenedProject> opened = open_project(given.project, session);
  if (!opened) return ExitCode::unusable_input;
  if (const ExitCode code = check_no_source(given.output, opened->project.state(), session.console); code != ExitCode::done) return code;
  session.progress().check();
  const Result<Done> written = export_layer(opened->project.state(), given.output, *options);
  session.console.issues(written.issues);
  if (!written) return ExitCode::failed;
  session.console.say(given.output + ": written");
  return session.write_json(result_json({{"output", given.output}}));
}

}  // namespace stemwise
