#pragma once
#include <optional>
#include <vector>

#include "core/geodesy/georeference.hpp"

namespace stemwise {

/// A point in the reference's frame (about some middle) and in a tangent plane on the earth (east, north, up), metres.
struct EarthPair {
  Eigen::Vector3d frame_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d enu_m = Eigen::Vector3d::Zero();
  bool has_up = false;       ///< both heights are known
  double weight = 1.0;       ///< 1 / variance, relative
};

/// enu = rotation * frame + shift.
struct EarthFit {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d operator*(const Eigen::Vector3d& frame_m) const { return rotation * frame_m + shift_m; }
  bool operator==(const EarthFit&) const = default;
};

/// Level: yaw and a planar shift by weighted least squares, the up shift as the weighted median of what is known.
/// `fixed_yaw_rad` keeps the direction. At least one pair with a fixed yaw, else two.
EarthFit fit_level(const std::vector<EarthPair>& pairs, std::optional<double> fixed_yaw_rad = std::nullopt);
/// All six degrees of freedom by weighted least squares (Horn 1987, through the singular value decomposition of Umeyama
/// 1991, without scale). Needs three pairs that are not on one line, all with heights.
EarthFit fit_tilted(const std::vector<EarthPair>& pairs);

double planar_residual_m(const EarthFit& fit, const EarthPair& pair);
double yaw_rad(const EarthFit& fit);

/// Standard deviations of a level fit: of its middle (one axis, m) and of its yaw (rad), from the residuals of its pairs.
/// `independent_share`: a track's errors last for minutes, so that its pairs count for fewer.
struct EarthFitError {
  double middle_m = 0.0;
  double yaw_rad = 0.0;
};
EarthFitError error_of(const EarthFit& fit, const std::vector<EarthPair>& pairs, int fitted, double independent_share = 1.0);

}  // namespace stemwise
