#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/field.hpp"
#include "core/forest/frame_set.hpp"

namespace stemwise {

/// A carried laser scanner that walks through a stand and keeps the trees around it, with the faults measured on real
/// frame folders (method.md 12): noise that grows with range, partial observation, smooth bias of base heights.
struct SimulateFramesSettings {
  double step_m = 2.0;            ///< between frames
  double lane_m = 25.0;           ///< between the lanes of the walk over the whole stand
  double range_m = 30.0;          ///< trees farther away are not seen
  double detection = 0.9;         ///< share of near trees that are seen; falls to half of it at full range
  double reconstruction = 0.7;    ///< share of seen near trees that are reconstructed; falls to a third of it at full range
  double position_noise_m = 0.04; ///< of a near reconstructed stem; grows with range, threefold for those not reconstructed
  double dbh_noise_m = 0.02;
  double axis_noise_deg = 2.5;
  double height_noise_m = 0.05;
  double height_bias_m = 0.3;     ///< size of the smooth bias of base heights along the walk
  double tilt_deg = 4.0;          ///< the sensor sways by about this in roll and pitch
  std::uint64_t seed = 0;
  Fields fields();
};

/// A walk to and fro over the extent of the stems, lanes along the longer side, one point per step.
std::vector<Eigen::Vector2d> walk_over(std::span<const Stem> stems, const SimulateFramesSettings& settings);

/// Local inventories along a path. Stems and poses share one frame, the survey's. Without base heights the ground is at 0,
/// without axes stems are upright. Deterministic by seed.
FrameSet simulate_frames(std::span<const Stem> stems, std::span<const Eigen::Vector2d> path_m, const SimulateFramesSettings& settings);

}  // namespace stemwise
