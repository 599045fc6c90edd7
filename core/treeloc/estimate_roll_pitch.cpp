#include "core/treeloc/estimate_roll_pitch.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace stemwise::treeloc {
namespace {

struct AxisPair {
  Eigen::Vector3d query;  ///< turned by the planar pose
  Eigen::Vector3d candidate;
};

/// Turn about a horizontal axis that takes `from` to `to` as well as one can without yaw.
Eigen::Matrix3d tilt_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d cross = from.cross(to);
  const Eigen::Vector3d horizontal(cross.x(), cross.y(), 0.0);
  const double sine = horizontal.norm();
  if (sine < 1e-12) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(std::atan2(sine, from.dot(to)), horizontal / sine).toRotationMatrix();
}

bool agrees(const AxisPair& p, const Eigen::Matrix3d& tilt, double least_cosine) {
  return p.candidate.dot(tilt * p.query) >= least_cosine;
}

}  // namespace

Fields EstimateRollPitchSettings::fields(const std::string& prefix) {
  return {{prefix + ".enabled", "", "Estimate residual roll and pitch from the axes of paired trees", &enabled},
          {prefix + ".inlier_deg", "deg", "Axes that agree to within this are inliers", &inlier_deg},
          {prefix + ".least_share", "", "Share of inliers below which roll and pitch stay zero", &least_share},
          {prefix + ".least_inliers", "", "Number of inliers below which roll and pitch stay zero", &least_inliers}};
}

Eigen::Matrix3d estimate_roll_pitch(const Scene& query, const Scene& candidate, std::span<const TreePair> pairs,
                                    const PlanarPose& pose, const EstimateRollPitchSettings& settings) {
  std::vector<AxisPair> axes;
  const Eigen::Matrix3d turn = pose.lifted().rotation;
  for (const TreePair& p : pairs) {
    const SceneTree &q = query.trees[p.query], &c = candidate.trees[p.candidate];
    if (q.has_axis() && c.has_axis()) axes.push_back({turn * q.axis, c.axis});
  }
  const double least_cosine = std::cos(radians(settings.inlier_deg));
  const auto count = [&](const Eigen::Matrix3d& tilt) {
    int n = 0;
    for (const AxisPair& p : axes) n += agrees(p, tilt, least_cosine) ? 1 : 0;
    return n;
  };
  Eigen::Matrix3d best = Eigen::Matrix3d::Identity();
  int most = 0;
  for (const AxisPair& p : axes) {
    const Eigen::Matrix3d tilt = tilt_between(p.query, p.candidate);
    if (const int n = count(tilt); n > most) most = n, best = tilt;
  }
  if (!settings.enabled || most < settings.least_inliers || most < settings.least_share * static_cast<double>(axes.size())) {
    return Eigen::Matrix3d::Identity();
  }
  Eigen::Vector3d mean_query = Eigen::Vector3d::Zero(), mean_candidate = Eigen::Vector3d::Zero();
  for (const AxisPair& p : axes) {
    if (agrees(p, best, least_cosine)) mean_query += p.query, mean_candidate += p.candidate;
  }
  return tilt_between(mean_query.normalized(), mean_candidate.normalized());
}

}  // namespace stemwise::treeloc
