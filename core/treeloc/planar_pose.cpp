#include "core/treeloc/planar_pose.hpp"

#include <cmath>

namespace stemwise::treeloc {

PlanarPose PlanarPose::from_yaw(double x_m, double y_m, double yaw_rad) {
  return {x_m, y_m, std::cos(yaw_rad), std::sin(yaw_rad)};
}

double PlanarPose::yaw_rad() const { return std::atan2(sine, cosine); }

double PlanarPose::displacement_m() const { return std::sqrt(x_m * x_m + y_m * y_m); }

RigidTransform PlanarPose::lifted() const {
  RigidTransform lifted;
  lifted.rotation << cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0;
  lifted.translation_m = {x_m, y_m, 0.0};
  return lifted;
}

PlanarPose planar_part(const RigidTransform& transform) {
  const double yaw =
      std::atan2(transform.rotation(1, 0) - transform.rotation(0, 1), transform.rotation(0, 0) + transform.rotation(1, 1));
  return PlanarPose::from_yaw(transform.translation_m.x(), transform.translation_m.y(), yaw);
}

PlanarPose fit_planar_pose(std::span<const PlanarPair> pairs) {
  double total = 0.0;
  Eigen::Vector2d mean_q = Eigen::Vector2d::Zero(), mean_c = Eigen::Vector2d::Zero();
  for (const PlanarPair& p : pairs) {
    total += p.weight;
    mean_q += p.weight * p.query;
    mean_c += p.weight * p.candidate;
  }
  if (total <= 0.0) return {};
  mean_q /= total;
  mean_c /= total;
  double dot = 0.0, cross = 0.0;
  for (const PlanarPair& p : pairs) {
    const Eigen::Vector2d q = p.query - mean_q, c = p.candidate - mean_c;
    dot += p.weight * q.dot(c);
    cross += p.weight * (q.x() * c.y() - q.y() * c.x());
  }
  const double length = std::sqrt(dot * dot + cross * cross);
  PlanarPose pose;
  if (length > 0.0) {
    pose.cosine = dot / length;
    pose.sine = cross / length;
  }
  pose.x_m = mean_c.x() - (pose.cosine * mean_q.x() - pose.sine * mean_q.y());
  pose.y_m = mean_c.y() - (pose.sine * mean_q.x() + pose.cosine * mean_q.y());
  return pose;
}

}  // namespace stemwise::treeloc
