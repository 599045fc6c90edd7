#pragma once
#include <span>
#include <vector>

namespace stemwise::treeloc {

/// One-to-one assignment of rows to columns of least total cost; min(rows, columns) of them are assigned. `cost` is row-major.
/// Gives the column of each row, -1 for a row left alone. Shortest augmenting paths with potentials (Kuhn, Munkres; Jonker,
/// Volgenant), O(n^3).
std::vector<int> least_cost_assignment(std::span<const double> cost, int rows, int columns);

}  // namespace stemwise::treeloc
