#pragma once
#include "io/stem_columns.hpp"

namespace stemwise {

/// Positions in degrees become metres in the UTM zone of the middle stem: where the columns say longitude and latitude, where the
/// file's system is one of degrees (`source.epsg`), and, with a warning, where x and y can be nothing else.
Issues project_degrees(const StemTable& table, const StemColumns& columns, Inventory& inventory);

}  // namespace stemwise
