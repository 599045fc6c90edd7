#pragma once
#include <array>

#include "io/position_columns.hpp"
#include "io/stem_table.hpp"

namespace stemwise {

/// In which unit a column is read, and how that was known.
struct UnitChoice {
  ColumnKind kind;
  std::string unit;
  std::string how;       ///< "by header", "as told", "median 31.5"
  bool guessed = false;
};

/// Which column of a table means what, and in which unit: everything that is needed to make stems of its rows.
struct StemColumns {
  PositionColumns position;
  std::array<std::optional<std::size_t>, column_kind_count> at;  ///< not those of the position
  std::optional<std::size_t> tag, stem_tag;  ///< together the id where a table has no better one
  double position_m = 1.0;       ///< metres per unit of x, y or distance
  double azimuth_rad = 0.0;      ///< radians per unit of azimuth
  double z_m = 1.0;
  double height_m = 1.0;
  double dbh_m = 1.0;            ///< of `dbh` or, divided by pi, of `circumference`
  double dbh_approximation_m = 1.0;
  std::optional<int> census_year;///< where the table has a column per census
  bool several_censuses = false; ///< then a stem without a diameter in this one was not there
  std::optional<std::size_t> genus;
  std::vector<UnitChoice> units; ///< one per column that has a unit
  std::vector<std::string> notes;///< "dbh: column DBH, cm (by header)"
  Issues issues;                 ///< guesses as warnings

  std::optional<std::size_t> operator[](ColumnKind kind) const { return at[static_cast<std::size_t>(kind)]; }
};

/// Recognises the columns of a table by the options, the header, the layout and, for units, the values. Failure when there
/// are no positions, or an option names a column or a unit that is not there.
Result<StemColumns> recognise_columns(const StemTable& table, const ReadOptions& options);

}  // namespace stemwise
