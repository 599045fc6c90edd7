#include "core/geometry/rigid_transform.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stemwise {

Eigen::Matrix4d RigidTransform::matrix() const {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = rotation;
  m.topRightCorner<3, 1>() = translation_m;
  return m;
}

RigidTransform RigidTransform::from_matrix(const Eigen::Matrix4d& matrix) {
  return {matrix.topLeftCorner<3, 3>(), matrix.topRightCorner<3, 1>()};
}

RigidTransform RigidTransform::planar(double x_m, double y_m, double yaw_rad) {
  return {rotation_from({0.0, 0.0, yaw_rad}), {x_m, y_m, 0.0}};
}

RollPitchYaw roll_pitch_yaw(const Eigen::Matrix3d& r) {
  return {std::atan2(r(2, 1), r(2, 2)), std::asin(std::clamp(-r(2, 0), -1.0, 1.0)), std::atan2(r(1, 0), r(0, 0))};
}

Eigen::Matrix3d rotation_from(const RollPitchYaw& a) {
  return (Eigen::AngleAxisd(a.yaw_rad, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(a.pitch_rad, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(a.roll_rad, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

double wrap_angle(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

double degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }
double radians(double angle_deg) { return angle_deg * std::numbers::pi / 180.0; }

}  // namespace stemwise
