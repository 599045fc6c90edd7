#include "core/survey/dbh_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stemwise {
namespace {

constexpr double lowest_density = 1e-5;  // per cm: one stem in 100,000 cm-classes
constexpr std::size_t most_classes = 4000;

double normal_density(double x, double sd) {
  const double u = x / sd;
  return u * u > 80.0 ? 0.0 : std::exp(-0.5 * u * u) / (sd * std::sqrt(2.0 * std::numbers::pi));
}

}  // namespace

DbhDensity::DbhDensity(std::span<const double> dbh_cm) {
  double largest_cm = 0.0;
  std::size_t count = 0;
  for (const double d : dbh_cm)
    if (d > 0.0) largest_cm = std::max(largest_cm, d), ++count;
  if (count == 0) return;
  const double end_cm = 1.5 * largest_cm + 10.0;
  step_cm_ = std::max(0.5, end_cm / static_cast<double>(most_classes));
  table_.assign(static_cast<std::size_t>(end_cm / step_cm_) + 2, lowest_density);
  const auto last = static_cast<double>(table_.size() - 1);
  for (const double d : dbh_cm) {
    if (d <= 0.0) continue;
    const double width_cm = std::max(1.0, 0.13 * d);
    const auto from = static_cast<std::size_t>(std::clamp((d - 4.0 * width_cm) / step_cm_, 0.0, last));
    const auto to = static_cast<std::size_t>(std::clamp((d + 4.0 * width_cm) / step_cm_ + 1.0, 0.0, last));
    for (std::size_t k = from; k <= to; ++k)
      table_[k] += normal_density(static_cast<double>(k) * step_cm_ - d, width_cm) / static_cast<double>(count);
  }
}

double DbhDensity::at(double dbh_cm) const {
  if (table_.empty()) return 1.0;
  const double place = std::clamp(dbh_cm / step_cm_, 0.0, static_cast<double>(table_.size() - 1));
  const auto k = std::min(static_cast<std::size_t>(place), table_.size() - 2);
  const double share = place - static_cast<double>(k);
  return (1.0 - share) * table_[k] + share * table_[k + 1];
}

double dbh_sd_cm(const DbhModel& model, double dbh_a_cm) { return model.scale * std::sqrt(9.0 + 0.01 * dbh_a_cm * dbh_a_cm); }

double dbh_evidence(const DbhModel& model, double dbh_a_cm, double dbh_b_cm, double density_b) {
  if (!model.used || dbh_a_cm <= 0.0 || dbh_b_cm <= 0.0) return 1.0;
  const double sd_cm = dbh_sd_cm(model, dbh_a_cm);
  const double off_cm = dbh_b_cm - dbh_a_cm - model.growth_cm;
  return (0.85 * normal_density(off_cm, sd_cm) + 0.12 * normal_density(off_cm, 3.0 * sd_cm)) / density_b + model.gross;
}

std::vector<DbhModel> dbh_bank(std::optional<double> years, bool any_dbh) {
  if (!any_dbh) return {DbhModel{false, 0.0, 1.0}};
  std::vector<DbhModel> bank{DbhModel{true, 0.0, 1.0}};
  // Faster than 0.3 cm a year is rare for a stand's median; below 6 cm the first model is wide enough for it.
  constexpr double usual_growth_cm_per_year = 0.3;
  if (!years) {
    bank.push_back({true, 12.0, 1.0});
    bank.push_back({true, -12.0, 1.0});
  } else if (std::abs(*years) * usual_growth_cm_per_year > 6.0) {
    bank.push_back({true, *years * usual_growth_cm_per_year, 1.0});
  }
  bank.push_back({false, 0.0, 1.0});
  return bank;
}

}  // namespace stemwise
