#pragma once
#include <optional>
#include <string>

#include "app/read_overrides.hpp"
#include "app/session.hpp"
#include "core/simulate/simulate_settings.hpp"

namespace stemwise {

struct SimulateOptions {
  std::string folder;
  std::vector<int> years;      ///< empty: 2015, 2019, 2023
  std::string resurvey;        ///< a real inventory to survey once more; empty: a forest of its own
  ReadOverrides read;          ///< of the real inventory
  SimulateSettings settings;
};

/// `stemwise simulate -o DIR`: one YEAR.csv (or YEAR/ with frames) per survey and truth/ beside them; with --resurvey one
/// resurvey.csv (or resurvey/).
ExitCode run_simulate(const SimulateOptions& options, Session& session);

}  // namespace stemwise
