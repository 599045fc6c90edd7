#pragma once
#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.hpp"

namespace stemwise::treeloc {

/// A rigid motion of the plane: candidate = turn by yaw, then shift. Applied to query coordinates, metres.
struct PlanarPose {
  double x_m = 0.0;
  double y_m = 0.0;
  double cosine = 1.0;
  double sine = 0.0;

  static PlanarPose from_yaw(double x_m, double y_m, double yaw_rad);
  Eigen::Vector2d operator*(const Eigen::Vector2d& p) const {
    return {cosine * p.x() - sine * p.y() + x_m, sine * p.x() + cosine * p.y() + y_m};
  }
  double yaw_rad() const;
  double displacement_m() const;
  RigidTransform lifted() const;  ///< T3D: the same motion in space, heights kept
};

/// The yaw and shift of a motion in space, seen from above.
PlanarPose planar_part(const RigidTransform& transform);

/// One point of the query, where it lies in the candidate, and how much it counts.
struct PlanarPair {
  Eigen::Vector2d query;
  Eigen::Vector2d candidate;
  double weight = 1.0;
};

/// Weighted least squares (eq. 5): the closed form in the plane, which is never a reflection. Identity turn for fewer than
/// two distinct points.
PlanarPose fit_planar_pose(std::span<const PlanarPair> pairs);

}  // namespace stemwise::treeloc
