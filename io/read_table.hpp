#pragma once
#include <string>

#include "core/base/result.hpp"
#include "core/forest/inventory.hpp"
#include "io/read_inventory.hpp"

namespace stemwise {

/// Reads a stem table from delimited text of any common kind (data-formats.md): encoding, delimiter, preamble, decimal sign,
/// columns and units are recognised.
Result<Inventory> read_table(const std::string& path, const ReadOptions& options = {});

}  // namespace stemwise
