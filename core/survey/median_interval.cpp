#include "core/survey/median_interval.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.hpp"

namespace stemwise {
namespace {

constexpr std::size_t groups = 20;

/// The interval of the median of what was measured, errors and all.
std::array<double, 2> rank_interval(const std::vector<double>& sorted) {
  const auto n = static_cast<double>(sorted.size());
  const double reach = 0.98 * std::sqrt(n);
  const auto low = static_cast<std::size_t>(std::max(0.0, std::floor(0.5 * n - reach)));
  const auto high = static_cast<std::size_t>(std::min(n - 1.0, std::ceil(0.5 * n + reach)));
  return {sorted[low], sorted[high]};
}

/// Second and third central moment of the values that are no gross errors: within `reach` of `middle`.
struct Moments {
  double variance = 0.0, third = 0.0;
};
Moments moments(const std::vector<double>& values, double middle, double reach) {
  const auto counts = [&](double v) { return std::abs(v - middle) <= reach; };
  double sum = 0.0, n = 0.0;
  for (const double v : values) {
    if (counts(v)) sum += v, n += 1.0;
  }
  Moments m;
  if (n == 0.0) return m;
  const double mean = sum / n;
  for (const double v : values) {
    if (!counts(v)) continue;
    const double d = v - mean;
    m.variance += d * d / n;
    m.third += d * d * d / n;
  }
  return m;
}

/// The median as it would be without errors of measurement.
double median_without_pull(const std::vector<double>& sorted) {
  constexpr double error_share = 0.8;     // of the variance below the median; the rest is growth that differs
  constexpr double least_growth = 0.15;   // of all variance: the errors are never taken to be nearly everything
  constexpr double widest_gap = 0.3;      // mean minus median in standard deviations, where the first order still holds
  constexpr double gross = 6.0;
  const double middle = quantile_of_sorted(sorted, 0.5), below = middle - quantile_of_sorted(sorted, 0.1587);
  const Moments m = moments(sorted, middle, gross * below);
  if (m.variance <= 0.0) return middle;
  const double of_growth = std::max(m.variance - error_share * below * below, least_growth * m.variance);
  const double widest = widest_gap * std::sqrt(of_growth);
  const double gap = std::clamp(m.third / (6.0 * of_growth), -widest, widest);
  return middle - (gap - m.third / (6.0 * m.variance));
}

std::vector<double> without_group(const std::vector<double>& values, std::size_t group) {
  std::vector<double> rest;
  rest.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % groups != group) rest.push_back(values[i]);
  }
  std::sort(rest.begin(), rest.end());
  return rest;
}

/// Standard error of median_without_pull by leaving out one group after the other (Quenouille 1956).
double jackknife_error(const std::vector<double>& values) {
  std::array<double, groups> without{};
  double mean = 0.0, sum = 0.0;
  for (std::size_t g = 0; g < groups; ++g) mean += (without[g] = median_without_pull(without_group(values, g))) / groups;
  for (const double w : without) sum += (w - mean) * (w - mean);
  return std::sqrt(sum * (groups - 1) / groups);
}

}  // namespace

std::array<double, 2> median_interval(const std::vector<double>& changes_m) {
  if (changes_m.empty()) return {};
  std::vector<double> sorted = changes_m;
  std::sort(sorted.begin(), sorted.end());
  std::array<double, 2> interval = rank_interval(sorted);
  if (sorted.size() < groups) return interval;
  const double true_median = median_without_pull(sorted), reach = 1.96 * jackknife_error(changes_m);
  return {std::min(interval[0], true_median - reach), std::max(interval[1], true_median + reach)};
}

}  // namespace stemwise
