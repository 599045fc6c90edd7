#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/survey/node_list.hpp"

namespace stemwise {

/// The diameters of one list as a density per cm (kernel estimate; step 2 of stem-lists.md).
class DbhDensity {
 public:
  DbhDensity() = default;
  explicit DbhDensity(std::span<const double> dbh_cm);  ///< negative: not measured
  double at(double dbh_cm) const;
  bool empty() const { return table_.empty(); }

 private:
  double step_cm_ = 0.5;
  std::vector<double> table_;
};

/// What one list's DBH says about the other's, cm: d_b - d_a is about `growth_cm`, give or take `scale` times
/// sqrt(3^2 + (0.1 d_a)^2); `gross` of them are misread and may be anything. Not `used`: positions only.
struct DbhModel {
  bool used = true;
  double growth_cm = 0.0;
  double scale = 1.0;
  double gross = 0.03;
  bool operator==(const DbhModel&) const = default;
};

/// g / f_B, the likelihood ratio of "these two diameters are one stem's" against "any two"; 1 where one is not measured.
/// `density_b` is f_B at `dbh_b_cm`.
double dbh_evidence(const DbhModel& model, double dbh_a_cm, double dbh_b_cm, double density_b);
/// Standard deviation of the DBH difference under the model.
double dbh_sd_cm(const DbhModel& model, double dbh_a_cm);

/// The models that a search goes through: no growth, the growth to expect in `years` (both directions where unknown), and
/// positions only, because units may have been guessed wrongly.
std::vector<DbhModel> dbh_bank(std::optional<double> years, bool any_dbh);

}  // namespace stemwise
