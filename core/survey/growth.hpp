#pragma once
#include <optional>
#include <vector>

#include "core/project/project_state.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {

/// Two measured diameters of one tree.
struct DbhPair {
  double earlier_m = 0.0;
  double later_m = 0.0;
  std::optional<double> years;
};

/// Figures of one pair of surveys (method.md 9, "temporal analysis"): the median with its 95 % interval
/// (median_interval), the 20-80 % band, and one measurement's error. `pairs` may be empty: then only n = 0 says something.
GrowthRow growth_between(InventoryId from, InventoryId to, std::optional<double> years, const std::vector<DbhPair>& pairs);

/// One measurement's DBH error (standard deviation, m) from the changes of matched stems: trees do not shrink by much, so
/// the spread below the median is error of two measurements, while the spread above is growth too. 0 below 8 pairs.
double dbh_error_from_changes_m(std::vector<double> changes_m);

/// Beyond 1.96 standard errors of the difference it grew or shrank.
ChangeClass classify_change(std::optional<double> change_m, double error_a_m, double error_b_m);

}  // namespace stemwise
