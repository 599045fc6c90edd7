#pragma once
#include <Eigen/Core>

namespace stemwise {

/// x' = rotation * x + translation, metres. Named by frames: `a_from_b` takes coordinates in b to coordinates in a.
struct RigidTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rotation * point + translation_m; }
  RigidTransform operator*(const RigidTransform& other) const {
    return {rotation * other.rotation, rotation * other.translation_m + translation_m};
  }
  RigidTransform inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation_m)}; }
  Eigen::Matrix4d matrix() const;
  static RigidTransform from_matrix(const Eigen::Matrix4d& matrix);
  /// Turn by yaw about +z (counter-clockwise from +x), then shift in the plane.
  static RigidTransform planar(double x_m, double y_m, double yaw_rad);

  bool operator==(const RigidTransform& o) const { return rotation == o.rotation && translation_m == o.translation_m; }
};

/// R = Rz(yaw) Ry(pitch) Rx(roll).
struct RollPitchYaw {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;
};

RollPitchYaw roll_pitch_yaw(const Eigen::Matrix3d& rotation);
Eigen::Matrix3d rotation_from(const RollPitchYaw& angles);
/// To (-pi, pi].
double wrap_angle(double angle_rad);
double degrees(double angle_rad);
double radians(double angle_deg);

}  // namespace stemwise
