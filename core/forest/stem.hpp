#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/date.hpp"
#include "core/forest/stem_status.hpp"

namespace stemwise {

/// One stem as one survey saw it. Lengths in metres in the frame of its inventory; what was not measured is empty.
struct Stem {
  std::string source_id;            ///< the id in the file, or its row number where it has none
  std::int64_t source_row = 0;      ///< 1-based line in the file, 0 when it came from many
  double x_m = 0.0;                 ///< stem centre at its base
  double y_m = 0.0;
  std::optional<double> z_m;        ///< terrain height at the base
  std::optional<double> dbh_m;      ///< measured diameter at breast height
  std::optional<double> dbh_approximation_m;  ///< a hint for matching only; never enters growth or fusion (data-formats.md)
  std::optional<Eigen::Vector3d> axis;        ///< unit vector along the stem, upwards
  std::optional<double> height_m;
  bool reconstructed = true;        ///< enough range and angular span (method.md, section 1); field-crew stems count as such
  double score = 1.0;               ///< 0..1
  int number_clusters = 1;          ///< partial observations
  int times_seen = 1;               ///< frames that saw it, for a global inventory made of frames
  StemStatus status = StemStatus::alive;
  std::optional<Date> date;         ///< the day this stem was measured, where the file says so
  std::string species;
  std::string note;

  bool operator==(const Stem&) const = default;
  /// What descriptors and matching use: measured, else approximate, else nothing.
  std::optional<double> dbh_for_matching_m() const { return dbh_m ? dbh_m : dbh_approximation_m; }
};

}  // namespace stemwise
