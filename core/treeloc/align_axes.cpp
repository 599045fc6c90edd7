#include "core/treeloc/align_axes.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/geometry/rigid_transform.hpp"

namespace stemwise::treeloc {
namespace {

/// The direction of largest scatter, upwards.
Eigen::Vector3d largest_eigenvector(const Eigen::Matrix3d& scatter) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(scatter);
  Eigen::Vector3d direction = solver.eigenvectors().col(2);
  if (direction.z() < 0.0) direction = -direction;
  return direction.normalized();
}

}  // namespace

Fields AlignAxesSettings::fields(const std::string& prefix) {
  return {{prefix + ".enabled", "", "Turn scenes so that the dominant stem axis is vertical", &enabled},
          {prefix + ".min_clusters", "", "Partial observations that a stem must have for its axis to count", &min_clusters},
          {prefix + ".min_trees", "", "Axes needed; with fewer the scene is left as it is", &min_trees},
          {prefix + ".robust_scale_deg", "deg", "Tilt at which an axis counts half", &robust_scale_deg},
          {prefix + ".refinements", "", "Reweighted steps after the closed form", &refinements}};
}

Eigen::Matrix3d rotation_to_vertical(const Eigen::Vector3d& from) {
  return Eigen::Quaterniond::FromTwoVectors(from, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

std::optional<Eigen::Matrix3d> align_axes(std::span<const Eigen::Vector3d> axes, const AlignAxesSettings& settings) {
  if (!settings.enabled || static_cast<int>(axes.size()) < settings.min_trees) return std::nullopt;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& axis : axes) scatter += axis * axis.transpose();
  Eigen::Vector3d dominant = largest_eigenvector(scatter);
  const double scale_sq = std::pow(std::sin(radians(settings.robust_scale_deg)), 2);
  for (int step = 0; step < settings.refinements; ++step) {
    scatter.setZero();
    for (const auto& axis : axes) {
      const double sine_sq = axis.cross(dominant).squaredNorm();
      scatter += axis * axis.transpose() / (1.0 + sine_sq / scale_sq);
    }
    dominant = largest_eigenvector(scatter);
  }
  return rotation_to_vertical(dominant);
}

}  // namespace stemwise::treeloc
