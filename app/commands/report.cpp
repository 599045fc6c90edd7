#include <algorithm>
#include <filesystem>

#include "app/check_output.hpp"
#include "app/commands/open_project.hpp"
#include "app/commands/project_commands.hpp"
#include "app/result_json.hpp"
#include "core/project/commands.hpp"
#include "core/survey/report_model.hpp"
#include "core/survey/tables.hpp"
#include "io/read_rule_pack.hpp"
#include "io/report/field_check.hpp"
#include "io/report/write_report.hpp"

namespace stemwise {
namespace {

constexpr const char* software = "Stemwise " STEMWISE_VERSION;

std::string suffix_of(const std::string& path) {
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}

std::string pack_names() {
  std::string names;
  for (const RulePack& pack : rule_packs()) names += pack.name + ", ";
  return names + "none, or a JSON file of own rules";
}

/// The pack that --rules names; done with no pack for "none".
Result<std::optional<RulePack>> named_rules(const std::string& name) {
  using Named = Result<std::optional<RulePack>>;
  if (name == "none") return std::optional<RulePack>();
  if (const RulePack* pack = find_rule_pack(name)) return std::optional(*pack);
  if (suffix_of(name) != ".json") return Named::failure(Issue{Severity::error, "", 0, "", "--rules " + name + ": expected " + pack_names(), ""});
  auto own = read_rule_pack(name);
  if (!own) return Named::failure(own.issues);
  return std::optional(std::move(*own));
}

/// Chooses the pack and keeps the choice in the project file; a project that cannot be written is a warning.
ExitCode choose_rules(const ReportCommandOptions& options, OpenedProject& opened, Session& session) {
  if (options.rules.empty()) return ExitCode::done;
  const auto pack = named_rules(options.rules);
  session.console.issues(pack.issues);
  if (!pack) return suffix_of(options.rules) == ".json" ? ExitCode::unusable_input : ExitCode::usage;
  Project& project = opened.project;
  const ProjectState before = project.state();
  for (const auto& [key, value] : settings_of(*pack)) project.execute(set_setting(key, value));
  if (project.state().settings == before.settings) return ExitCode::done;
  if (save_project(options.project, opened, session) != ExitCode::done) session.console.warn("the choice of rules could not be kept in " + options.project);
  return ExitCode::done;
}

void say_counts(const ReportModel& model, Console& console) {
  for (const ReportRule& rule : model.rules)
    if (rule.is_chosen) console.say(rule.count.flag + ": " + std::to_string(rule.count.broken) + " of " + std::to_string(rule.count.judged) + " pairs");
}

Result<Done> write_field_check(const ReportCommandOptions& options, const ProjectState& state, const Tables& tables) {
  const FieldCheck check = make_field_check(state, tables, options.field_check_trees);
  if (suffix_of(options.output) == ".gpx") return write_field_check_gpx(options.output, check, state.georeference, software);
  const bool for_print = suffix_of(options.output) == ".pdf" || suffix_of(options.output).starts_with(".htm");
  return write_report(options.output, make_field_check_document(check, state, software, for_print));
}

}  // namespace

ExitCode run_report(const ReportCommandOptions& options, Session& session) {
  constexpr double least_ha = 1e-4, most_ha = 1e6;  // a square metre, a country
  if (options.area_ha && !(*options.area_ha >= least_ha && *options.area_ha <= most_ha)) {
    session.console.error("--area-ha: expected an area in hectares between 0.0001 and 1000000");
    return ExitCode::usage;
  }
  std::vector<std::string> suffixes = report_suffixes();
  if (options.field_check) suffixes.emplace_back(".gpx");
  if (const ExitCode code = check_suffix(options.output, suffixes, options.field_check ? "a field check sheet" : "a report", session.console); code != ExitCode::done) return code;
  if (const ExitCode code = check_output(options.output, OutputKind::other, {options.project}, session.console); code != ExitCode::done) return code;
  std::optional<OpenedProject> opened = open_project(options.project, session);
  if (!opened) return ExitCode::unusable_input;
  if (const ExitCode code = check_no_source(options.output, opened->project.state(), session.console); code != ExitCode::done) return code;
  if (const ExitCode code = choose_rules(options, *opened, session); code != ExitCode::done) return code;
  const Tables tables = derive_tables(opened->project.state());
  if (tables.inventories.empty()) {
    session.console.error(options.project + ": no survey of this project has been aligned, so there is nothing to report");
    return ExitCode::failed;
  }
  session.progress().check();
  Result<Done> written;
  if (options.field_check) {
    written = write_field_check(options, opened->project.state(), tables);
  } else {
    const ReportModel model = make_report_model(opened->project.state(), tables, {options.area_ha, options.class_width_cm});
    say_counts(model, session.console);
    written = write_report(options.output, make_report_document(model, software));
  }
  session.console.issues(written.issues);
  if (!written) return ExitCode::failed;
  session.console.say(options.output + ": written");
  return session.write_json(result_json({{"output", options.output}}));
}

}  // namespace stemwise
