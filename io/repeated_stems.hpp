#pragma once
#include "io/stem_columns.hpp"

namespace stemwise {

/// Takes out the stems whose row says the very same as an earlier one (row numbers apart) under the same id, and tells it in a
/// warning. Several stems of one tree differ in something. Where the file has no ids they stay, and the warning says so.
/// `rows`: the table row of each stem.
Issues leave_out_repeated_rows(const StemTable& table, const StemColumns& columns, std::vector<Stem>& stems, std::vector<std::size_t>& rows);

/// A warning for stems that stand apart under one id: several stems of one tree share it rightly, two trees do not. Plots may
/// each count their own.
Issues warn_of_repeated_ids(const StemTable& table, const StemColumns& columns, const std::vector<Stem>& stems);

}  // namespace stemwise
