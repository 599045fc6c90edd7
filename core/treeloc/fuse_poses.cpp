#include "core/treeloc/fuse_poses.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

namespace stemwise::treeloc {
namespace {

/// Element-wise weighted median of positions: where the reweighting starts, so that no single pose decides it.
Eigen::Vector3d median_position(std::span<const WeightedPose> poses) {
  Eigen::Vector3d median;
  std::vector<double> values(poses.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < poses.size(); ++i) values[i] = poses[i].survey_from_query.translation_m[axis];
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[axis] = *middle;
  }
  return median;
}

}  // namespace

Fields FusePosesSettings::fields(const std::string& prefix) {
  return {{prefix + ".enabled", "", "Average the poses that several verified scenes give", &enabled},
          {prefix + ".most", "", "Verified scenes whose poses are averaged", &most},
          {prefix + ".position_scale_m", "m", "Deviation in position at which a pose counts half", &position_scale_m},
          {prefix + ".rotation_scale_deg", "deg", "Deviation in rotation at which a pose counts half", &rotation_scale_deg}};
}

RigidTransform fuse_poses(std::span<const WeightedPose> poses, const FusePosesSettings& settings) {
  if (poses.empty()) return {};
  if (poses.size() < 3) return poses.front().survey_from_query;
  RigidTransform fused{poses.front().survey_from_query.rotation, median_position(poses)};
  const double position_sq = settings.position_scale_m * settings.position_scale_m;
  const double rotation_sq = std::pow(radians(settings.rotation_scale_deg), 2);
  for (int i = 0; i < 8; ++i) {
    Eigen::Vector3d shift = Eigen::Vector3d::Zero(), turn = Eigen::Vector3d::Zero();
    double shift_weight = 0.0, turn_weight = 0.0;
    for (const WeightedPose& p : poses) {
      const Eigen::Vector3d dt = p.survey_from_query.translation_m - fused.translation_m;
      const Eigen::AngleAxisd angle(fused.rotation.transpose() * p.survey_from_query.rotation);
      const Eigen::Vector3d dr = angle.angle() * angle.axis();
      const double wt = p.weight / (1.0 + dt.squaredNorm() / position_sq);
      const double wr = p.weight / (1.0 + dr.squaredNorm() / rotation_sq);
      shift += wt * dt;
      shift_weight += wt;
      turn += wr * dr;
      turn_weight += wr;
    }
    fused.translation_m += shift / shift_weight;
    turn /= turn_weight;
    if (turn.norm() > 0.0) fused.rotation = fused.rotation * Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  }
  return fused;
}

}  // namespace stemwise::treeloc
