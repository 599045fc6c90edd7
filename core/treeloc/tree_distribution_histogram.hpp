#pragma once
#include <string>
#include <vector>

#include "core/base/field.hpp"
#include "core/treeloc/scene.hpp"

namespace stemwise::treeloc {

/// TDH (method.md, section 4): how many trees lie at which distance from the origin with which diameter.
struct TdhSettings {
  bool enabled = true;
  int radial_bins = 5;
  double radial_width_m = 6.0;
  double radial_overlap_m = 1.0;
  int dbh_bins = 8;
  double dbh_step_m = 0.1;
  double dbh_width_m = 0.15;
  bool count_once = true;  ///< a tree in two overlapping bins counts in the first one only
  Fields fields(const std::string& prefix);
};

/// radial_bins x dbh_bins raw counts, row by row, after a 2x2 uniform smoothing.
std::vector<float> tree_distribution_histogram(const Scene& scene, const TdhSettings& settings);

}  // namespace stemwise::treeloc
