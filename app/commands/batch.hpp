#pragma once
#include <string>

#include "app/session.hpp"

namespace stemwise {

struct BatchOptions {
  std::string manifest;
  std::string folder;
  int shard = 1;   ///< K of K/N
  int shards = 1;  ///< N
};

/// `stemwise batch MANIFEST.csv -o DIR`: every plot aligned into DIR/PLOT (project.gpkg, align.json), a row each in
/// summary.csv (summary-K.csv for a shard) and timing.csv. A failed plot stops nothing; what is there and unchanged is not
/// done again.
ExitCode run_batch(const BatchOptions& options, Session& session);

}  // namespace stemwise
