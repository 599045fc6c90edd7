#pragma once
#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// The rotation that takes the dominant one of `axes` (unit vectors, sign-free) to +z without any turn about it (eq. 1).
/// Nothing when there are fewer than `min_trees`. Closed form by the scatter matrix, then reweighted (Cauchy kernel).
std::optional<Eigen::Matrix3d> align_axes(std::span<const Eigen::Vector3d> axes, const AlignAxesSettings& settings);

/// The smallest rotation that takes the unit vector `from` to +z.
Eigen::Matrix3d rotation_to_vertical(const Eigen::Vector3d& from);

}  // namespace stemwise::treeloc
