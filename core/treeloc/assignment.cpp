#include "core/treeloc/assignment.hpp"

#include <limits>

namespace stemwise::treeloc {
namespace {

/// Column of each row, for rows <= columns. Row 0 and column 0 of the working arrays stand for "none".
std::vector<int> assign_wide(std::span<const double> cost, int rows, int columns, bool transposed) {
  const auto at = [&](int r, int c) {
    return transposed ? cost[static_cast<std::size_t>(c * rows + r)] : cost[static_cast<std::size_t>(r * columns + c)];
  };
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<double> row_potential(static_cast<std::size_t>(rows) + 1, 0.0),
      column_potential(static_cast<std::size_t>(columns) + 1, 0.0);
  std::vector<std::size_t> row_of(static_cast<std::size_t>(columns) + 1, 0), way(static_cast<std::size_t>(columns) + 1, 0);
  for (std::size_t row = 1; row <= static_cast<std::size_t>(rows); ++row) {
    row_of[0] = row;
    std::size_t column = 0;
    std::vector<double> least(static_cast<std::size_t>(columns) + 1, infinite);
    std::vector<char> done(static_cast<std::size_t>(columns) + 1, 0);
    do {
      done[column] = 1;
      const std::size_t here = row_of[column];
      double delta = infinite;
      std::size_t next = 0;
      for (std::size_t c = 1; c < least.size(); ++c) {
        if (done[c] != 0) continue;
        const double reduced =
            at(static_cast<int>(here) - 1, static_cast<int>(c) - 1) - row_potential[here] - column_potential[c];
        if (reduced < least[c]) least[c] = reduced, way[c] = column;
        if (least[c] < delta) delta = least[c], next = c;
      }
      for (std::size_t c = 0; c < least.size(); ++c) {
        if (done[c] != 0) {
          row_potential[row_of[c]] += delta;
          column_potential[c] -= delta;
        } else {
          least[c] -= delta;
        }
      }
      column = next;
    } while (row_of[column] != 0);
    for (; column != 0; column = way[column]) row_of[column] = row_of[way[column]];
  }
  std::vector<int> column_of(static_cast<std::size_t>(rows), -1);
  for (std::size_t c = 1; c < row_of.size(); ++c) {
    if (row_of[c] != 0) column_of[row_of[c] - 1] = static_cast<int>(c) - 1;
  }
  return column_of;
}

}  // namespace

std::vector<int> least_cost_assignment(std::span<const double> cost, int rows, int columns) {
  if (rows <= 0 || columns <= 0) return std::vector<int>(static_cast<std::size_t>(rows > 0 ? rows : 0), -1);
  if (rows <= columns) return assign_wide(cost, rows, columns, false);
  const std::vector<int> row_of = assign_wide(cost, columns, rows, true);
  std::vector<int> column_of(static_cast<std::size_t>(rows), -1);
  for (std::size_t c = 0; c < row_of.size(); ++c) column_of[static_cast<std::size_t>(row_of[c])] = static_cast<int>(c);
  return column_of;
}

}  // namespace stemwise::treeloc
