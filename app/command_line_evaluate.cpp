#include <memory>

#include <CLI/CLI.hpp>

#include "app/command_registry.hpp"
#include "app/commands/evaluate.hpp"

namespace stemwise {
namespace {

void add_options(CLI::App& command, EvaluateOptions& options) {
  command.add_option("--method", options.method, "stemwise (default), treeloc++ (as published), treeloc (its predecessor)");
  command.add_option("--csv", options.csv, "Write a row per query to this file");
  command.add_option("--map-mode", options.map_mode,
                     "frames (default), or global: the map's trees as one list, cut on a 5 m grid");
}

}  // namespace

void add_evaluate_commands(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& evaluate = add_command(root, common, "evaluate", "The paper's metrics on frame folders with true trajectories");
  evaluate.require_subcommand(1);
  const auto options = std::make_shared<EvaluateOptions>();
  const auto run = [options, &chosen] { chosen.run = [options](Session& session) { return run_evaluate(*options, session); }; };
  CLI::App& intra = add_command(evaluate, common, "intra", "A survey against its own earlier frames");
  intra.add_option("DIR", options->query_folder, "Frame folder")->required();
  add_options(intra, *options);
  intra.callback(run);
  CLI::App& inter = add_command(evaluate, common, "inter", "One survey's frames against another's");
  inter.add_option("QUERY_DIR", options->query_folder, "Frame folder of the queries")->required();
  inter.add_option("MAP_DIR", options->map_folder, "Frame folder of the map")->required();
  inter.add_option("--regions", options->regions, "FILE:KEY, JSON polygons: only queries inside count");
  add_options(inter, *options);
  inter.callback(run);
}

}  // namespace stemwise
