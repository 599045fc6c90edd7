#pragma once
#include "core/forest/inventory.hpp"
#include "io/stem_table.hpp"

namespace stemwise {

/// Makes the inventory of a table: plot chosen, columns recognised, every usable row a stem, every bad row an issue. `epsg`
/// is the system of the table's x and y where it is known. Failure when no row is usable.
Result<Inventory> inventory_from_table(StemTable table, const ReadOptions& options, std::optional<int> epsg = std::nullopt);
Result<Inventory> inventory_from_table(OpenedTable opened, const ReadOptions& options);

}  // namespace stemwise
