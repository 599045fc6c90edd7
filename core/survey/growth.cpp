#include "core/survey/growth.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.hpp"
#include "core/survey/median_interval.hpp"

namespace stemwise {

GrowthRow growth_between(InventoryId from, InventoryId to, std::optional<double> years, const std::vector<DbhPair>& pairs) {
  GrowthRow row;
  row.from = from;
  row.to = to;
  row.n = static_cast<int>(pairs.size());
  std::vector<double> changes, spans;
  for (const DbhPair& pair : pairs) {
    changes.push_back(pair.later_m - pair.earlier_m);
    if (pair.years) spans.push_back(*pair.years);
  }
  row.years = spans.empty() ? years : std::optional(median(spans));
  if (changes.empty()) return row;
  row.ci95_m = median_interval(changes);
  std::sort(changes.begin(), changes.end());
  row.median_change_m = quantile_of_sorted(changes, 0.5);
  row.p20_p80_m = {quantile_of_sorted(changes, 0.2), quantile_of_sorted(changes, 0.8)};
  row.dbh_error_m = dbh_error_from_changes_m(changes);
  return row;
}

double dbh_error_from_changes_m(std::vector<double> changes_m) {
  if (changes_m.size() < 8) return 0.0;
  std::sort(changes_m.begin(), changes_m.end());
  // Median minus the 15.87 % quantile is one standard deviation of a normal difference; two measurements share it.
  const double spread = quantile_of_sorted(changes_m, 0.5) - quantile_of_sorted(changes_m, 0.1587);
  return spread / std::sqrt(2.0);
}

ChangeClass classify_change(std::optional<double> change_m, double error_a_m, double error_b_m) {
  if (!change_m) return ChangeClass::unknown;
  const double limit = 1.96 * std::hypot(error_a_m, error_b_m);
  if (std::abs(*change_m) <= limit) return ChangeClass::within_error;
  return *change_m > 0.0 ? ChangeClass::grew : ChangeClass::shrank;
}

}  // namespace stemwise
