#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace stemwise {

/// A row of `evaluate --csv` (cli.md): differences of the pose from the truth in metres and degrees; empty where nothing was
/// found.
struct QueryResult {
  std::int64_t query = 0;
  std::int64_t candidate = -1;  ///< -1: nothing was found
  bool positive = false;
  double score = 0.0;
  double position_m[3] = {0.0, 0.0, 0.0};
  double angle_deg[3] = {0.0, 0.0, 0.0};  ///< roll, pitch, yaw
};

/// Columns by header, in any order. Bad rows are issues and left out; failure when a column is missing or no row is usable.
Result<std::vector<QueryResult>> read_query_rows(const std::string& path);

}  // namespace stemwise
