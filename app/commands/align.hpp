#pragma once
#include <string>
#include <vector>

#include "app/read_overrides.hpp"
#include "app/session.hpp"

namespace stemwise {

struct AlignOptions {
  std::vector<std::string> inventories;  ///< a project first: the others are added to it
  std::string output;     ///< PROJECT.gpkg
  std::string reference;  ///< name; empty: the inventory with the most trees
  std::string hint;       ///< JSON file
  std::string crs;        ///< EPSG:N that the coordinates of all inventories are in; empty: unknown
  bool accept_probable = false;
  ReadOverrides read;
};

/// `stemwise align INVENTORY... -o PROJECT.gpkg`: reads, aligns, matches and writes a project. `failed` when two
/// inventories could not be aligned, or none of more could: then the JSON is written and the project is not.
ExitCode run_align(const AlignOptions& options, Session& session);

}  // namespace stemwise
