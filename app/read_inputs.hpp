#pragma once
#include <string>
#include <vector>

#include "app/read_overrides.hpp"
#include "app/session.hpp"
#include "core/base/result.hpp"
#include "core/forest/inventory.hpp"

namespace stemwise {

/// One path of the command line after reading.
struct ReadInput {
  std::string path;
  std::string name;  ///< the file's stem or the folder's name; a second of the same name got "-2"
  Result<Inventory> inventory;
};

/// Names in the order given, made unique ("plot", "plot-2", ...).
std::vector<std::string> inventory_names(const std::vector<std::string>& paths);

/// Reads every path, each with the overrides meant for its name. Nothing is said yet: issues lie in the results. Usage
/// mistakes in the overrides (an unknown NAME:, no "=") come back in `usage`.
struct ReadInputs {
  std::vector<ReadInput> inputs;
  Issues usage;
};
ReadInputs read_inputs(const std::vector<std::string>& paths, const ReadOverrides& overrides, Session& session, const Progress& progress);

}  // namespace stemwise
