#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/survey/tables.hpp"

namespace stemwise {

/// A figure and its 95 % interval.
struct Estimate {
  double value = 0.0;
  std::array<double, 2> ci95{};
};

/// DBH change of the matched living stems of one step between two surveys. Measurement error has mean 0, so it leaves the
/// mean where it is; the median of a skewed distribution it draws towards the mean, which is why both are given. Metres.
struct StandGrowth {
  InventoryId from, to;
  std::optional<double> years;              ///< median of the stems' own spans
  int n = 0;
  Estimate mean_m;                          ///< bootstrap (bias-corrected percentile, Efron 1987)
  Estimate mean_m_per_year;                 ///< each stem by its own years; both 0 without years
  Estimate median_m;                        ///< its interval: median_interval
  Estimate robust_m;                        ///< Huber's M-estimate of location (k = 1.5), its sandwich standard error
  std::array<double, 2> p20_p80_m{};
  double dbh_error_from_m = 0.0, dbh_error_to_m = 0.0;  ///< one measurement's standard deviation in each survey
  double detection_limit_m = 0.0;           ///< a single tree's change beyond this is no mere error (95 %)
};

struct StandGrowthSettings {
  int resamples = 1000;
  std::uint64_t seed = 0;
};

/// One row per step between consecutive placed surveys by date. Deterministic by seed, at any number of threads.
std::vector<StandGrowth> stand_growth(const ProjectState& state, const Tables& tables, const StandGrowthSettings& settings = {});

/// The smallest change of one tree that measurement error does not explain, 95 % (two-sided): 1.96 standard deviations of
/// the difference of two measurements with these errors.
double detection_limit_m(double error_a_m, double error_b_m);

/// Mean with its bias-corrected bootstrap interval. `values` in any order; fewer than 2: no width.
Estimate bootstrap_mean(const std::vector<double>& values, const StandGrowthSettings& settings);
/// Huber's location: gross errors (wrong matches, misread tapes) count little.
Estimate huber_location(const std::vector<double>& values);

}  // namespace stemwise
