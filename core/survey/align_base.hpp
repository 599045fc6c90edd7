#pragma once
#include <vector>

#include "core/base/ids.hpp"
#include "core/survey/alignment.hpp"

namespace stemwise {

/// What stays as it is while surveys are added: poses of inventories already aligned, and which of their stems are one
/// tree. Empty: everything is found anew.
struct AlignBase {
  std::vector<InventoryAlignment> poses;    ///< the reference among them
  std::vector<std::vector<StemRef>> trees;  ///< every stem of those inventories is in exactly one
};

}  // namespace stemwise
