#pragma once
#include <span>

#include "io/stem_table.hpp"

namespace stemwise {

/// Keeps the rows of one plot, as the options ask; without the question nothing is done. Failure when the column or the
/// value is not there (the values that are there are named).
Result<Done> keep_one_plot(StemTable& table, const ReadOptions& options);

/// Columns that may tell plots apart and hold more than one value.
std::vector<std::size_t> plot_columns_with_several_values(const StemTable& table);

/// A warning when the table holds several plots whose stems lie on top of each other, as plots with coordinates of their
/// own do. `x_m`, `y_m` belong to `rows` (indices into `table.rows`). `own_centres`: they are known to have.
Issues warn_of_overlapping_plots(const StemTable& table, std::span<const std::size_t> rows, std::span<const double> x_m,
                                 std::span<const double> y_m, bool own_centres);

/// Index of the row's plot by the first such column, 0 when there is none; and how many plots there are.
struct PlotGroups {
  std::optional<std::size_t> column;
  std::vector<std::string> values;       ///< in order of appearance
  std::vector<std::size_t> group_of_row; ///< per table row
};
PlotGroups plot_groups(const StemTable& table);

}  // namespace stemwise
