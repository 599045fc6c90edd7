#include "core/survey/level_by_axes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/rigid_transform.hpp"

namespace stemwise {
namespace {

/// The sine of the angle between two lines: sign-free, and exact for small angles where an arc cosine is not.
double sine_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.cross(b).norm(); }

Eigen::Vector3d dominant_line(const Eigen::Matrix3d& scatter) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  Eigen::Vector3d line = solver.eigenvectors().col(2);
  if (line.z() < 0.0) line = -line;  // a survey may lean, it does not hang upside down
  return line;
}

/// Closed form first, then reweighted (Cauchy) until it stands still.
Eigen::Vector3d robust_dominant_line(std::span<const Eigen::Vector3d> axes, double scale) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& axis : axes) scatter += axis * axis.transpose();
  Eigen::Vector3d line = dominant_line(scatter);
  for (int round = 0; round < 20; ++round) {
    scatter.setZero();
    for (const auto& axis : axes) {
      const double s = sine_between(axis, line) / scale;
      scatter += axis * axis.transpose() / (1.0 + s * s);
    }
    const Eigen::Vector3d next = dominant_line(scatter);
    const bool still = sine_between(next, line) < 1e-9;
    line = next;
    if (still) break;
  }
  return line;
}

double median_angle_rad(std::span<const Eigen::Vector3d> axes, const Eigen::Vector3d& line) {
  std::vector<double> sines;
  sines.reserve(axes.size());
  for (const auto& axis : axes) sines.push_back(std::min(1.0, sine_between(axis, line)));
  const auto middle = sines.begin() + static_cast<std::ptrdiff_t>(sines.size() / 2);
  std::nth_element(sines.begin(), middle, sines.end());
  return std::asin(*middle);
}

std::vector<Eigen::Vector3d> axes_of(std::span<const Stem> stems, bool only_well_observed) {
  std::vector<Eigen::Vector3d> axes;
  for (const Stem& stem : stems) {
    if (!stem.axis || !stem.axis->allFinite() || stem.axis->norm() < 0.5) continue;
    if (only_well_observed && (!stem.reconstructed || stem.number_clusters <= 2)) continue;
    axes.push_back(stem.axis->normalized());
  }
  return axes;
}

}  // namespace

Fields LevelSettings::fields() {
  return {{"level.least_axes", "", "A list with fewer stem axes is not levelled.", &least_axes},
          {"level.inlier_angle_deg", "deg", "Stem axes farther than this from the dominant one count less.", &inlier_angle_deg}};
}

Levelling level_by_axes(std::span<const Eigen::Vector3d> axes, const LevelSettings& settings) {
  Levelling result;
  if (axes.size() < static_cast<std::size_t>(std::max(1, settings.least_axes))) return result;
  const Eigen::Vector3d line = robust_dominant_line(axes, std::sin(radians(settings.inlier_angle_deg)));
  result.level_from_survey = Eigen::Quaterniond::FromTwoVectors(line, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  result.observed = true;
  result.axes = static_cast<int>(axes.size());
  result.tilt_rad = std::asin(std::min(1.0, sine_between(line, Eigen::Vector3d::UnitZ())));
  result.spread_rad = median_angle_rad(axes, line);
  return result;
}

Levelling level_by_axes(std::span<const Stem> stems, const LevelSettings& settings) {
  const std::vector<Eigen::Vector3d> best = axes_of(stems, true);
  if (best.size() >= static_cast<std::size_t>(std::max(1, settings.least_axes))) return level_by_axes(best, settings);
  return level_by_axes(axes_of(stems, false), settings);
}

}  // namespace stemwise
