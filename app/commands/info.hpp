#pragma once
#include <string>
#include <vector>

#include "app/read_overrides.hpp"
#include "app/session.hpp"

namespace stemwise {

struct InfoOptions {
  std::vector<std::string> paths;
  ReadOverrides read;
};

/// `stemwise info PATH...`: what was recognised in each, and every problem. unusable_input when one of them cannot be used.
ExitCode run_info(const InfoOptions& options, Session& session);

}  // namespace stemwise
