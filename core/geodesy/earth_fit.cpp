#include "core/geodesy/earth_fit.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "core/geometry/rigid_transform.hpp"

namespace stemwise {
namespace {

struct Middles {
  Eigen::Vector3d frame_m = Eigen::Vector3d::Zero(), enu_m = Eigen::Vector3d::Zero();
  double weight = 0.0;
};

Middles middles_of(const std::vector<EarthPair>& pairs) {
  Middles out;
  for (const EarthPair& pair : pairs) {
    out.frame_m += pair.weight * pair.frame_m;
    out.enu_m += pair.weight * pair.enu_m;
    out.weight += pair.weight;
  }
  out.frame_m /= out.weight;
  out.enu_m /= out.weight;
  return out;
}

double best_yaw_rad(const std::vector<EarthPair>& pairs, const Middles& middle) {
  double dot = 0.0, cross = 0.0;
  for (const EarthPair& pair : pairs) {
    const Eigen::Vector2d a = (pair.frame_m - middle.frame_m).head<2>(), b = (pair.enu_m - middle.enu_m).head<2>();
    dot += pair.weight * a.dot(b);
    cross += pair.weight * (a.x() * b.y() - a.y() * b.x());
  }
  return std::atan2(cross, dot);
}

/// The middle one of two; 0 when no height is known.
double weighted_median_up_m(const std::vector<EarthPair>& pairs) {
  std::vector<std::pair<double, double>> ups;  // up, weight
  double total = 0.0;
  for (const EarthPair& pair : pairs)
    if (pair.has_up) {
      ups.emplace_back(pair.enu_m.z() - pair.frame_m.z(), pair.weight);
      total += pair.weight;
    }
  std::sort(ups.begin(), ups.end());
  double below = 0.0;
  for (std::size_t i = 0; i < ups.size(); ++i) {
    below += ups[i].second;
    if (std::abs(2.0 * below - total) <= 1e-12 * total && i + 1 < ups.size()) return 0.5 * (ups[i].first + ups[i + 1].first);
    if (2.0 * below > total) return ups[i].first;
  }
  return 0.0;
}

}  // namespace

EarthFit fit_level(const std::vector<EarthPair>& pairs, std::optional<double> fixed_yaw_rad) {
  const Middles middle = middles_of(pairs);
  EarthFit fit;
  fit.rotation = rotation_from({0.0, 0.0, fixed_yaw_rad ? *fixed_yaw_rad : best_yaw_rad(pairs, middle)});
  fit.shift_m = middle.enu_m - fit.rotation * middle.frame_m;
  fit.shift_m.z() = weighted_median_up_m(pairs);
  return fit;
}

EarthFit fit_tilted(const std::vector<EarthPair>& pairs) {
  const Middles middle = middles_of(pairs);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const EarthPair& pair : pairs) covariance += pair.weight * (pair.enu_m - middle.enu_m) * (pair.frame_m - middle.frame_m).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) signs.z() = -1.0;
  EarthFit fit;
  fit.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  fit.shift_m = middle.enu_m - fit.rotation * middle.frame_m;
  return fit;
}

double planar_residual_m(const EarthFit& fit, const EarthPair& pair) { return (fit * pair.frame_m - pair.enu_m).head<2>().norm(); }

double yaw_rad(const EarthFit& fit) { return std::atan2(fit.rotation(1, 0), fit.rotation(0, 0)); }

EarthFitError error_of(const EarthFit& fit, const std::vector<EarthPair>& pairs, int fitted, double independent_share) {
  const Middles middle = middles_of(pairs);
  double sum_sq = 0.0, spread_sq = 0.0;
  for (const EarthPair& pair : pairs) {
    sum_sq += pair.weight * planar_residual_m(fit, pair) * planar_residual_m(fit, pair);
    spread_sq += pair.weight * (pair.frame_m - middle.frame_m).head<2>().squaredNorm();
  }
  const double share = independent_share;
  const double free = share * 2.0 * static_cast<double>(pairs.size()) - fitted;
  if (free <= 0.0) return {};
  const double unit_sq = share * sum_sq / free;  // variance of one axis of a pair of weight 1
  EarthFitError error;
  error.middle_m = std::sqrt(unit_sq / (share * middle.weight));
  if (spread_sq > 0.0) error.yaw_rad = std::sqrt(unit_sq / (share * spread_sq));
  return error;
}

}  // namespace stemwise
