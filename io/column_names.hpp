#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stemwise {

/// What a column of a stem table can mean. The words are those of `--map`.
enum class ColumnKind {
  x, y, z, lon, lat, azimuth, distance, dbh, circumference, dbh_approximation, height, id, species, status, date, plot,
  axis_x, axis_y, axis_z, number_clusters, reconstructed, score, quadrat, local_x, local_y
};
inline constexpr std::size_t column_kind_count = 25;
const char* to_string(ColumnKind kind);
std::optional<ColumnKind> column_kind_from(std::string_view word);

/// A header cell taken apart: "DBH_2018 (mm)" is base "dbh", unit "mm", year 2018.
struct ColumnName {
  std::string base;         ///< lower-case letters and digits, accents removed
  std::string unit;         ///< one of ours (m, dm, cm, mm, ft, in, deg, gon, rad) or empty
  std::optional<int> year;  ///< of a census, where the column is one of several
};
ColumnName parse_column_name(std::string_view header);

/// Words of letters and digits: lower case, accents removed.
std::vector<std::string> plain_words(std::string_view text);

/// How good a name `name` is for `kind`: 0 is the best, larger is weaker; nothing when it is no name for it.
std::optional<int> name_rank(const ColumnName& name, ColumnKind kind);

/// "m" for "metres", "in" for "inches"; empty when it is no unit of ours.
std::string unit_from_word(std::string_view word);
/// Metres per unit, 0 for angles and unknown words.
double metres_per(std::string_view unit);
/// Radians per unit, 0 for lengths and unknown words.
double radians_per(std::string_view unit);

/// For "easting" "northing"; nothing when the name is not the first of a pair that we know. `rank` as in name_rank.
struct PairName {
  std::string partner;
  int rank = 0;
};
std::optional<PairName> position_partner(const std::string& base);

}  // namespace stemwise
