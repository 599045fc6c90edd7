#pragma once
#include <Eigen/Core>
#include <span>

#include "core/base/field.hpp"
#include "core/forest/stem.hpp"

namespace stemwise {

struct LevelSettings {
  int least_axes = 5;             ///< fewer axes level nothing
  double inlier_angle_deg = 10.0; ///< axes farther from the dominant one than this count less (Cauchy weight)
  Fields fields();
};

/// The rotation that makes a list upright. Without axes: identity and not observed.
struct Levelling {
  Eigen::Matrix3d level_from_survey = Eigen::Matrix3d::Identity();  ///< takes the dominant stem axis to +z, turns no more than that
  bool observed = false;
  int axes = 0;              ///< that were used
  double tilt_rad = 0.0;     ///< how far the dominant axis was from +z
  double spread_rad = 0.0;   ///< median angle of the axes to the dominant one
};

/// Levels a list by its dominant stem axis (method.md 3, eq. 1-2). Axes are lines: their sign does not matter.
/// Uses the well-observed stems (reconstructed, more than two clusters) where there are enough, else all with an axis.
Levelling level_by_axes(std::span<const Stem> stems, const LevelSettings& settings = {});
/// The same for bare directions.
Levelling level_by_axes(std::span<const Eigen::Vector3d> axes, const LevelSettings& settings = {});

}  // namespace stemwise
