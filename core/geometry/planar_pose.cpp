#include "core/geometry/planar_pose.hpp"

#include <cmath>

namespace stemwise {

PlanarMap::PlanarMap(const PlanarPose& pose) : c(std::cos(pose.yaw_rad)), s(std::sin(pose.yaw_rad)), tx(pose.x_m), ty(pose.y_m) {}

Eigen::Matrix2d PlanarPose::rotation() const {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

Eigen::Vector2d PlanarPose::operator*(const Eigen::Vector2d& p) const { return PlanarMap(*this)(p.x(), p.y()); }

PlanarPose PlanarPose::operator*(const PlanarPose& o) const {
  const Eigen::Vector2d t = *this * Eigen::Vector2d(o.x_m, o.y_m);
  return {t.x(), t.y(), wrap_angle(yaw_rad + o.yaw_rad)};
}

PlanarPose PlanarPose::inverse() const {
  const Eigen::Vector2d t = -(rotation().transpose() * Eigen::Vector2d(x_m, y_m));
  return {t.x(), t.y(), wrap_angle(-yaw_rad)};
}

PlanarPose planar_part(const RigidTransform& t) {
  return {t.translation_m.x(), t.translation_m.y(), roll_pitch_yaw(t.rotation).yaw_rad};
}

}  // namespace stemwise
