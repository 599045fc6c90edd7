#pragma once
#include <string>

#include "app/session.hpp"

namespace stemwise {

struct EvaluateOptions {
  std::string query_folder;
  std::string map_folder;           ///< empty: intra, the folder against itself
  std::string regions;              ///< FILE:KEY, inter only; empty: every query counts
  std::string csv;                  ///< a row per query; empty: none
  std::string method = "stemwise";  ///< stemwise, treeloc++, treeloc
  std::string map_mode = "frames";  ///< frames, or global: the map's trees as one list, cut on a grid
};

/// `stemwise evaluate intra DIR` and `evaluate inter QUERY_DIR MAP_DIR`: the paper's metrics (method.md, section 10).
ExitCode run_evaluate(const EvaluateOptions& options, Session& session);

}  // namespace stemwise
