#include "app/commands/batch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/align_job.hpp"
#include "app/align_json.hpp"
#include "app/align_run.hpp"
#include "app/check_output.hpp"
#include "app/read_inputs.hpp"
#include "app/result_json.hpp"
#include "core/base/fingerprint.hpp"
#include "io/project_file.hpp"
#include "io/read_manifest.hpp"
#include "io/write_inventory.hpp"
#include "io/write_whole_file.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

constexpr const char* summary_head =
    "plot,status,inventories,aligned,unique_trees,matched,residual_rms_m,growth_median_cm_per_year,problems\n";

void add_file(const fs::path& path, Fingerprint& fingerprint) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  fingerprint.add(text.str());
}

void add_input(const std::string& path, Fingerprint& fingerprint) {
  std::error_code code;
  if (!fs::is_directory(path, code)) return add_file(path, fingerprint);
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, code)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    fingerprint.add(file.filename().string());
    add_file(file, fingerprint);
  }
}

/// Of everything that a plot's result depends on.
std::string fingerprint_of(const ManifestPlot& plot, const Session& session) {
  Fingerprint fingerprint;
  fingerprint.add(STEMWISE_VERSION);
  fingerprint.add(std::to_string(session.common.seed));
  for (const auto& [key, value] : given_settings(session.common).values) fingerprint.add(key + "=" + value);
  for (const ManifestRow& row : plot.rows) {
    fingerprint.add(row.name + "|" + row.date + "|" + (row.is_reference ? "1" : "0") + "|" + fs::path(row.path).filename().string());
    add_input(row.path, fingerprint);
  }
  return fingerprint.text();
}

AlignOptions options_of(const ManifestPlot& plot) {
  AlignOptions options;
  for (const ManifestRow& row : plot.rows) options.inventories.push_back(row.path);
  options.read.names = inventory_names(options.inventories);
  for (std::size_t i = 0; i < plot.rows.size(); ++i) {
    if (!plot.rows[i].name.empty()) options.read.names[i] = plot.rows[i].name;
    if (!plot.rows[i].date.empty()) options.read.date.push_back(options.read.names[i] + ":" + plot.rows[i].date);
    if (plot.rows[i].is_reference) options.reference = options.read.names[i];
  }
  return options;
}

const char* status_word(ExitCode code) {
  switch (code) {
    case ExitCode::done: return "done";
    case ExitCode::unusable_input: return "unusable_input";
    case ExitCode::usage: return "bad_manifest";
    default: return "failed";
  }
}

std::string csv_cell(std::string text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '"');
  return '"' + text + '"';
}

struct PlotResult {
  std::string summary;  ///< one line of summary.csv
  std::string timing;   ///< one line of timing.csv; empty when nothing was done
};

std::string problems_of(const ProjectState& state) {
  std::string problems;
  if (state.inventories.size() == 1) problems = "one inventory only: there is nothing to align it to";
  for (const auto& [id, alignment] : state.alignments) {
    if (!alignment.reason.empty()) problems += (problems.empty() ? "" : "; ") + state.find(id)->name + ": " + alignment.reason;
  }
  return problems;
}

/// The medians of all steps over the years of all steps: one figure for a table of plots.
std::string growth_text(const Tables& tables) {
  double sum_cm = 0.0, years = 0.0;
  for (const GrowthRow& row : tables.growth) {
    if (!row.years || row.n == 0) continue;
    sum_cm += row.median_change_m * 100.0;
    years += *row.years;
  }
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", years > 0.0 ? sum_cm / years : 0.0);
  return years > 0.0 ? text : "";
}

std::string summary_line(const ManifestPlot& plot, ExitCode code, const AlignRun& run) {
  const ProjectState& state = run.project.state();
  int aligned = 0, matched = 0;
  double squares = 0.0;
  for (const auto& [id, alignment] : state.alignments) {
    if (alignment.status != AlignmentStatus::aligned) continue;
    ++aligned;
    matched += alignment.matched;
    squares += alignment.matched * alignment.residual_rms_m * alignment.residual_rms_m;
  }
  std::string line = csv_cell(plot.plot) + "," + status_word(code) + "," + std::to_string(plot.rows.size()) + "," + std::to_string(aligned);
  line += run.code == ExitCode::done ? "," + std::to_string(run.tables.trees.size()) + "," + std::to_string(matched) + "," : ",,,";
  line += (matched > 0 ? exact_number(std::round(std::sqrt(squares / matched) * 1e6) / 1e6) : "") + "," + growth_text(run.tables) + "," + csv_cell(run.problem.empty() ? problems_of(state) : run.problem);
  return line + "\n";
}

PlotResult align_plot(const ManifestPlot& plot, const fs::path& folder, Session& session) {
  const AlignOptions options = options_of(plot);
  const AlignRun run = run_alignment(options, session);
  if (run.code != ExitCode::done) return {summary_line(plot, run.code, run), csv_cell(plot.plot) + ",\n"};
  const ProjectState& state = run.project.state();
  ExitCode code = judge_alignment(state, session.console);
  const Result<Done> written = write_whole_file((folder / "align.json").string(), align_json(state, run.tables, run.rejected, run.timing, run.seed));
  session.console.issues(written.issues);
  bool complete = static_cast<bool>(written);
  if (complete && code == ExitCode::done) {
    const auto project = write_project(state, (folder / "project.gpkg").string());
    session.console.issues(project.issues);
    complete = static_cast<bool>(project);
  }
  if (!complete) code = ExitCode::failed;
  return {summary_line(plot, code, run), csv_cell(plot.plot) + "," + exact_number(run.timing.total_s) + "\n"};
}

bool holds_an_object(const fs::path& json) {
  std::ifstream in(json);
  char first = '\0';
  return in >> first && first == '{';
}

/// Whether the files of an earlier run are still there: a project only where one was written.
bool results_are_there(const fs::path& folder, const std::string& summary) {
  const bool has_project = summary.find(std::string(",") + status_word(ExitCode::done) + ",") != std::string::npos;
  const bool has_json = has_project || fs::exists(folder / "align.json");
  return (!has_json || holds_an_object(folder / "align.json")) && (!has_project || is_project((folder / "project.gpkg").string()));
}

/// What an earlier run left for this very input, or nothing.
std::optional<std::string> earlier_summary(const fs::path& folder, const std::string& fingerprint) {
  std::ifstream in(folder / "summary.txt");
  std::string mark, line;
  if (!std::getline(in, mark) || mark != fingerprint || !std::getline(in, line) || !results_are_there(folder, line)) return std::nullopt;
  return line + "\n";
}

/// A folder beside the plot's own, which takes its place when all of it is there: an interrupted run leaves the results of the one before.
class FolderInTheMaking {
 public:
  explicit FolderInTheMaking(const fs::path& place) : place_(place), partial_(place.parent_path() / ("." + place.filename().string() + ".partial")) {
    std::error_code code;
    fs::remove_all(partial_, code);
    fs::create_directories(partial_, code);
  }
  FolderInTheMaking(const FolderInTheMaking&) = delete;
  FolderInTheMaking& operator=(const FolderInTheMaking&) = delete;
  ~FolderInTheMaking() {
    std::error_code code;
    fs::remove_all(partial_, code);
  }
  const fs::path& path() const { return partial_; }
  /// False when the file system would not.
  bool finish() {
    std::error_code code;
    fs::remove_all(place_, code);
    fs::rename(partial_, place_, code);
    return !code;
  }

 private:
  fs::path place_, partial_;
};

PlotResult do_plot(const ManifestPlot& plot, const BatchOptions& options, Session& session) {
  const fs::path folder = fs::path(options.folder) / plot.plot;
  const std::string fingerprint = fingerprint_of(plot, session);
  if (const auto earlier = earlier_summary(folder, fingerprint)) {
    session.console.say(plot.plot + ": unchanged");
    return {*earlier, ""};
  }
  session.console.say(plot.plot + ": " + std::to_string(plot.rows.size()) + " inventories");
  const auto not_done = [&](std::string problem) {
    AlignRun run;
    run.code = ExitCode::failed;
    run.problem = std::move(problem);
    return PlotResult{summary_line(plot, run.code, run), csv_cell(plot.plot) + ",\n"};
  };
  if (check_decisions_kept((folder / "project.gpkg").string(), session.console) != ExitCode::done)
    return not_done("its project holds edits made by hand and was left as it is: move the folder away to align anew");
  FolderInTheMaking made(folder);
  PlotResult result = align_plot(plot, made.path(), session);
  session.console.issues(write_whole_file((made.path() / "summary.txt").string(), fingerprint + "\n" + result.summary).issues);
  if (!made.finish()) return not_done("its folder could not be replaced");
  return result;
}

}  // namespace

ExitCode run_batch(const BatchOptions& options, Session& session) {
  if (options.shards < 1 || options.shard < 1 || options.shard > options.shards) {
    session.console.error("--shard K/N: K lies between 1 and N");
    return ExitCode::usage;
  }
  AlignJobSettings settings;  // looked at once for all plots, before anything is touched
  if (const ExitCode code = session.apply_settings(settings.fields()); code != ExitCode::done) return code;
  const auto plots = read_manifest(options.manifest);
  session.console.issues(plots.issues);
  if (!plots) return ExitCode::unusable_input;
  std::error_code code;
  fs::create_directories(options.folder, code);
  std::string summary = summary_head, timing = "plot,total_s\n";
  for (std::size_t i = static_cast<std::size_t>(options.shard - 1); i < plots->size(); i += static_cast<std::size_t>(options.shards)) {
    const PlotResult result = do_plot((*plots)[i], options, session);
    summary += result.summary;
    timing += result.timing;
  }
  const std::string suffix = options.shards > 1 ? "-" + std::to_string(options.shard) : "";
  Result<Done> written = write_whole_file((fs::path(options.folder) / ("summary" + suffix + ".csv")).string(), summary);
  if (written) written = write_whole_file((fs::path(options.folder) / ("timing" + suffix + ".csv")).string(), timing);
  session.console.issues(written.issues);
  if (!written) return ExitCode::failed;
  return session.write_json(result_json({{"output", options.folder}, {"summary", "summary" + suffix + ".csv"}, {"plots", static_cast<std::int64_t>(plots->size())}}));
}

}  // namespace stemwise
