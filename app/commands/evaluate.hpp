#pragma once
#include <string>
#include <vector>

#include "app/commands/evaluate_setup.hpp"
#include "app/session.hpp"

namespace stemwise {

struct EvaluateOptions {
  EvaluateMethodOptions method;
  std::string query_folder;
  std::string map_folder;  ///< empty: intra, the folder against itself
  std::string csv;         ///< a row per query; empty: none
  std::string plots;       ///< folder for charts as PNG and SVG; empty: none
  std::string cache;       ///< folder where descriptors are kept between runs; empty: the person's cache folder
  bool no_cache = false;
};
/// `stemwise evaluate intra DIR` and `evaluate inter QUERY_DIR MAP_DIR`: the paper's metrics (method.md, section 10).
ExitCode run_evaluate(const EvaluateOptions& options, Session& session);

struct EvaluatePairsOptions {
  EvaluateMethodOptions method;
  std::vector<std::string> folders;
  std::string csv;    ///< a row per directed pair; empty: none
  std::string plots;  ///< a folder; empty: none
};
/// `stemwise evaluate pairs DIR...`: every survey in every other one, means, stability, thresholds carried over.
ExitCode run_evaluate_pairs(const EvaluatePairsOptions& options, Session& session);

struct EvaluateCompareOptions {
  std::string a, b;      ///< result CSVs of the same queries
  int resamples = 2500;  ///< of the bootstrap, as in the paper
};
/// `stemwise evaluate compare A.csv B.csv`: exact McNemar, Wilcoxon signed-rank, paired bootstrap.
ExitCode run_evaluate_compare(const EvaluateCompareOptions& options, Session& session);

struct EvaluateSweepOptions {
  EvaluateMethodOptions method;
  std::string query_folder;
  std::string map_folder;          ///< empty: intra
  std::string what = "ablations";  ///< ablations, deletion, noise, rotation, radius, sigma_t, defaults, all
  std::string output;              ///< .csv or .md; empty: stdout only
  int trials = 3;                  ///< of what is random
};
/// `stemwise evaluate sweep`: one table of the paper's ablations and robustness tests.
ExitCode run_evaluate_sweep(const EvaluateSweepOptions& options, Session& session);

}  // namespace stemwise
