#include <memory>

#include <CLI/CLI.hpp>

#include "app/command_registry.hpp"
#include "app/commands/evaluate.hpp"

namespace stemwise {
namespace {

void add_method(CLI::App& command, EvaluateMethodOptions& options) {
  command.add_option("--method", options.method, "stemwise (default), treeloc++ (as published), treeloc (its predecessor)");
}

void add_map(CLI::App& command, EvaluateMethodOptions& options) {
  command.add_option("--map-mode", options.map_mode,
                     "frames (default), or global: the map's trees as one list, cut on a 5 m grid");
  command.add_option("--regions", options.regions, "FILE:KEY, JSON polygons: only queries inside count");
}

void add_outputs(CLI::App& command, std::string& csv, const char* csv_help, std::string& plots) {
  command.add_option("--csv", csv, csv_help);
  command.add_option("--plots", plots, "Folder for charts as PNG and SVG: precision-recall, errors, time per query");
}

template <class Options>
std::function<void()> runner(const std::shared_ptr<Options>& options, ExitCode (*run)(const Options&, Session&), ChosenCommand& chosen) {
  return [options, run, &chosen] { chosen.run = [options, run](Session& session) { return run(*options, session); }; };
}

void add_one(CLI::App& evaluate, CommonOptions& common, ChosenCommand& chosen) {
  const auto options = std::make_shared<EvaluateOptions>();
  CLI::App& intra = add_command(evaluate, common, "intra", "A survey against its own earlier frames");
  intra.add_option("DIR", options->query_folder, "Frame folder")->required();
  CLI::App& inter = add_command(evaluate, common, "inter", "One survey's frames against another's");
  inter.add_option("QUERY_DIR", options->query_folder, "Frame folder of the queries")->required();
  inter.add_option("MAP_DIR", options->map_folder, "Frame folder of the map")->required();
  add_map(inter, options->method);
  for (CLI::App* command : {&intra, &inter}) {
    add_method(*command, options->method);
    add_outputs(*command, options->csv, "Write a row per query to this file", options->plots);
    command->add_option("--cache", options->cache, "Folder where descriptors are kept between runs (default ~/.cache/stemwise; at most 1 GB)");
    command->add_flag("--no-cache", options->no_cache, "Read and describe the frames, whatever is kept, and keep nothing");
    command->callback(runner(options, run_evaluate, chosen));
  }
}

void add_pairs(CLI::App& evaluate, CommonOptions& common, ChosenCommand& chosen) {
  const auto options = std::make_shared<EvaluatePairsOptions>();
  CLI::App& pairs = add_command(evaluate, common, "pairs", "Every survey in every other one: means, stability, thresholds carried over");
  pairs.add_option("DIR", options->folders, "Frame folders with trajectories in one frame")->required();
  add_method(pairs, options->method);
  add_map(pairs, options->method);
  add_outputs(pairs, options->csv, "Write a row per directed pair to this file", options->plots);
  pairs.callback(runner(options, run_evaluate_pairs, chosen));
}

void add_compare(CLI::App& evaluate, CommonOptions& common, ChosenCommand& chosen) {
  const auto options = std::make_shared<EvaluateCompareOptions>();
  CLI::App& compare = add_command(evaluate, common, "compare", "Two results (--csv) of the same queries: McNemar, Wilcoxon, bootstrap");
  compare.add_option("A", options->a, "Result CSV")->required();
  compare.add_option("B", options->b, "Result CSV")->required();
  compare.add_option("--resamples", options->resamples, "Samples of the bootstrap (default 2500)")->check(CLI::Range(0, 1000000));
  compare.callback(runner(options, run_evaluate_compare, chosen));
}

void add_sweep(CLI::App& evaluate, CommonOptions& common, ChosenCommand& chosen) {
  const auto options = std::make_shared<EvaluateSweepOptions>();
  CLI::App& sweep = add_command(evaluate, common, "sweep", "A table of what changes when steps are left out, trees lost, frames turned");
  sweep.add_option("DIR", options->query_folder, "Frame folder (of the queries)")->required();
  sweep.add_option("MAP_DIR", options->map_folder, "Frame folder of the map; without it DIR against itself");
  sweep.add_option("--what", options->what, "ablations (default), deletion, noise, rotation, radius, sigma_t, defaults, or all");
  sweep.add_option("-o,--output", options->output, "The table as .csv or .md");
  sweep.add_option("--trials", options->trials, "Seeds that random cases are repeated with (default 3)");
  add_method(sweep, options->method);
  add_map(sweep, options->method);
  sweep.callback(runner(options, run_evaluate_sweep, chosen));
}

}  // namespace

void add_evaluate_commands(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& evaluate = add_command(root, common, "evaluate", "The paper's metrics on frame folders with true trajectories");
  evaluate.require_subcommand(1);
  add_one(evaluate, common, chosen);
  add_pairs(evaluate, common, chosen);
  add_compare(evaluate, common, chosen);
  add_sweep(evaluate, common, chosen);
}

}  // namespace stemwise
