#pragma once
#include <Eigen/Core>

#include "core/geometry/rigid_transform.hpp"

namespace stemwise {

/// A turn by yaw about +z and a shift in the plane: `b_from_a * p` takes planar coordinates in a to those in b. Metres, radians.
struct PlanarPose {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;

  Eigen::Matrix2d rotation() const;
  Eigen::Vector2d operator*(const Eigen::Vector2d& point) const;
  PlanarPose operator*(const PlanarPose& other) const;
  PlanarPose inverse() const;
  RigidTransform rigid() const { return RigidTransform::planar(x_m, y_m, yaw_rad); }
  bool operator==(const PlanarPose&) const = default;
};

/// The planar part (x, y, yaw) of a rigid transform.
PlanarPose planar_part(const RigidTransform& transform);

/// Applies one pose to many points: the turn's sine and cosine are taken once.
struct PlanarMap {
  explicit PlanarMap(const PlanarPose& pose);
  Eigen::Vector2d operator()(double x, double y) const { return {c * x - s * y + tx, s * x + c * y + ty}; }
  double c, s, tx, ty;
};

}  // namespace stemwise
