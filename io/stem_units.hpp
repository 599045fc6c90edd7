#pragma once
#include "io/stem_columns.hpp"

namespace stemwise {

/// Decides the unit of every column that is in use: by the options, the header, a known layout, or the values; the last is a
/// guess and becomes a warning.
void decide_units(const StemTable& table, const ReadOptions& options, StemColumns& columns);

}  // namespace stemwise
