#pragma once
#include "io/stem_table.hpp"

namespace stemwise {

/// How a table says where a stem stands.
enum class PositionScheme { cartesian, geographic, polar, quadrat };

/// `first` and `second` are x and y, longitude and latitude, azimuth and distance, or local x and y (with `quadrat`).
struct PositionColumns {
  PositionScheme scheme = PositionScheme::cartesian;
  std::size_t first = 0;
  std::size_t second = 0;
  std::size_t quadrat = 0;
  std::vector<std::string> others;  ///< other positions in the table, "Xutm/Yutm", for a note
};

/// Chooses the columns that hold positions: by the options, else by name, preferring what varies from row to row (a
/// plot centre repeated on every row is no position). Failure, naming what was looked for and what is there.
Result<PositionColumns> choose_position_columns(const StemTable& table, const ReadOptions& options);

/// Median of the values, nothing when there are none.
std::optional<double> median_of(std::vector<double> values);

}  // namespace stemwise
