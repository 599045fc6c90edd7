#include "core/survey/stand_growth.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/quantile.hpp"
#include "core/base/random.hpp"
#include "core/survey/median_interval.hpp"

namespace stemwise {
namespace {

constexpr double normal_95 = 1.959964;

/// Standard normal distribution and its inverse (Acklam's rational approximation, 1e-9, is more than is needed: bisection).
double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }
double normal_quantile(double p) {
  double low = -8.0, high = 8.0;
  for (int i = 0; i < 60; ++i) (normal_cdf(0.5 * (low + high)) < p ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

/// Bias-corrected percentiles of the replicates (Efron 1987, eq. 2.3 without acceleration).
std::array<double, 2> corrected_percentiles(std::vector<double> replicates, double value) {
  std::sort(replicates.begin(), replicates.end());
  const auto below = static_cast<double>(std::lower_bound(replicates.begin(), replicates.end(), value) - replicates.begin());
  const auto up_to = static_cast<double>(std::upper_bound(replicates.begin(), replicates.end(), value) - replicates.begin());
  const double share = std::clamp(0.5 * (below + up_to) / static_cast<double>(replicates.size()), 0.01, 0.99);  // ties count half
  const double bias = normal_quantile(share);
  return {quantile_of_sorted(replicates, normal_cdf(2.0 * bias - normal_95)), quantile_of_sorted(replicates, normal_cdf(2.0 * bias + normal_95))};
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

struct Changes {
  std::vector<double> change_m, per_year_m, years;
};

/// Living stems of consecutive surveys with two measured diameters.
std::vector<Changes> changes_per_step(const ProjectState& state, const Tables& tables) {
  std::unordered_map<InventoryId, std::size_t> place;
  for (std::size_t i = 0; i < tables.inventories.size(); ++i) place[tables.inventories[i]] = i;
  std::vector<Changes> steps(tables.inventories.empty() ? 0 : tables.inventories.size() - 1);
  const auto alive = [&](StemRef ref) { return is_living(state.find(ref)->status); };
  for (const MatchRow& match : tables.matches) {
    if (match.state == MatchState::rejected || !match.change_m || place.at(match.a.inventory) + 1 != place.at(match.b.inventory)) continue;
    if (!alive(match.a) || !alive(match.b)) continue;
    Changes& step = steps[place.at(match.a.inventory)];
    step.change_m.push_back(*match.change_m);
    if (!match.years || *match.years <= 0.0) continue;
    step.years.push_back(*match.years);
    step.per_year_m.push_back(*match.change_m / *match.years);
  }
  return steps;
}

double dbh_error_of(const Tables& tables, InventoryId id) {
  for (const ObservationRow& row : tables.observations)
    if (row.stem.inventory == id && row.dbh_error_m) return *row.dbh_error_m;
  return 0.0;
}

}  // namespace

double detection_limit_m(double error_a_m, double error_b_m) { return normal_95 * std::hypot(error_a_m, error_b_m); }

Estimate bootstrap_mean(const std::vector<double>& values, const StandGrowthSettings& settings) {
  Estimate estimate;
  if (values.empty()) return estimate;
  std::vector<double> sample = values;
  estimate.value = mean_of(sample);
  estimate.ci95 = {estimate.value, estimate.value};
  if (values.size() < 2) return estimate;
  Random random(settings.seed, 1);
  std::vector<double> replicates;
  for (int r = 0; r < std::max(200, settings.resamples); ++r) {
    for (double& v : sample) v = values[random.below(values.size())];
    replicates.push_back(mean_of(sample));
  }
  estimate.ci95 = corrected_percentiles(std::move(replicates), estimate.value);
  return estimate;
}

Estimate huber_location(const std::vector<double>& values) {
  constexpr double k = 1.5;
  Estimate estimate;
  if (values.empty()) return estimate;
  double at = median(values);
  std::vector<double> off;
  for (const double v : values) off.push_back(std::abs(v - at));
  const double scale = std::max(1e-9, 1.4826 * median(off));
  double spread = 0.0, slope = 0.0;
  for (int round = 0; round < 50; ++round) {
    double sum = 0.0;
    spread = slope = 0.0;
    for (const double v : values) {
      const double z = (v - at) / scale, psi = std::clamp(z, -k, k);
      sum += psi;
      spread += psi * psi;
      slope += std::abs(z) <= k ? 1.0 : 0.0;
    }
    const double step = scale * sum / std::max(1.0, slope);
    at += step;
    if (std::abs(step) < 1e-9) break;
  }
  const double error = scale * std::sqrt(spread) / std::max(1.0, slope);
  return {at, {at - normal_95 * error, at + normal_95 * error}};
}

std::vector<StandGrowth> stand_growth(const ProjectState& state, const Tables& tables, const StandGrowthSettings& settings) {
  std::vector<StandGrowth> rows;
  const std::vector<Changes> steps = changes_per_step(state, tables);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    StandGrowth row;
    row.from = tables.inventories[i];
    row.to = tables.inventories[i + 1];
    row.n = static_cast<int>(steps[i].change_m.size());
    row.dbh_error_from_m = dbh_error_of(tables, row.from);
    row.dbh_error_to_m = dbh_error_of(tables, row.to);
    row.detection_limit_m = detection_limit_m(row.dbh_error_from_m, row.dbh_error_to_m);
    if (!steps[i].years.empty()) row.years = median(steps[i].years);
    row.mean_m = bootstrap_mean(steps[i].change_m, settings);
    row.mean_m_per_year = bootstrap_mean(steps[i].per_year_m, settings);
    row.median_m = {median(steps[i].change_m), median_interval(steps[i].change_m)};
    row.robust_m = huber_location(steps[i].change_m);
    if (row.n > 0) {
      std::vector<double> sorted = steps[i].change_m;
      std::sort(sorted.begin(), sorted.end());
      row.p20_p80_m = {quantile_of_sorted(sorted, 0.2), quantile_of_sorted(sorted, 0.8)};
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace stemwise
