#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "core/base/quantile.hpp"
#include "core/treeloc/evaluate.hpp"

namespace stemwise::treeloc {
namespace {

constexpr double chi_square_95_of_3 = 7.814727903251179;

/// Squared Mahalanobis distance of three of the six numbers.
double part_sq(const Eigen::Vector3d& error, const Eigen::Matrix3d& covariance) { return error.dot(covariance.ldlt().solve(error)); }

}  // namespace

Calibration calibration_of(std::span<const QueryRow> rows) {
  Calibration c;
  std::vector<double> position_sd_m, rotation_sd_deg;
  for (const QueryRow& row : rows) {
    if (!row.found()) continue;
    const Eigen::AngleAxisd turn(row.true_candidate_from_query.rotation * row.candidate_from_query.rotation.transpose());
    const Eigen::Vector3d shift = row.true_candidate_from_query.translation_m - row.candidate_from_query.translation_m;
    const Eigen::Matrix3d position = row.covariance.topLeftCorner<3, 3>(), rotation = row.covariance.bottomRightCorner<3, 3>();
    ++c.poses;
    c.inside_95 += row.mahalanobis_sq <= chi_square_95_of_6 ? 1.0 : 0.0;
    c.inside_95_position += part_sq(shift, position) <= chi_square_95_of_3 ? 1.0 : 0.0;
    c.inside_95_rotation += part_sq(turn.angle() * turn.axis(), rotation) <= chi_square_95_of_3 ? 1.0 : 0.0;
    position_sd_m.push_back(std::sqrt(position.trace()));
    rotation_sd_deg.push_back(degrees(std::sqrt(rotation.trace())));
  }
  const double n = std::max(1, c.poses);
  c.inside_95 /= n;
  c.inside_95_position /= n;
  c.inside_95_rotation /= n;
  c.median_position_sd_m = median(position_sd_m);
  c.median_rotation_sd_deg = median(rotation_sd_deg);
  return c;
}

}  // namespace stemwise::treeloc
