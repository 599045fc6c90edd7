#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/field.hpp"
#include "core/forest/stem.hpp"
#include "core/geometry/rigid_transform.hpp"
#include "core/survey/alignment.hpp"

namespace stemwise {

struct SixDofSettings {
  double planar_floor_m = 0.05;       ///< the robust scales are never below these
  double height_floor_m = 0.05;
  double axis_floor_deg = 0.5;
  double height_bias_m = 0.15;        ///< smooth error of base heights that more trees do not average away
  double axis_bias_deg = 0.3;         ///< the same of stem axes
  double tilt_tolerance_deg = 1.0;    ///< roll and pitch are observed when their standard deviation is below this
  int least_heights = 3;              ///< agreeing pairs with base heights for z (method.md 7.4)
  int least_axes = 5;                 ///< agreeing pairs with axes for roll and pitch (method.md 7.3)
  int rounds = 12;
  Fields fields();
};

/// One stem of the reference and the one of the query that is held to be the same tree, by index.
struct IndexPair {
  std::size_t reference = 0;
  std::size_t query = 0;
  bool operator==(const IndexPair&) const = default;
};

struct SixDofReport {
  RigidTransform reference_from_query;  ///< rigid; roll, pitch and z are zero where they were not observed
  ObservedDofs observed;
  std::vector<std::string> notes;       ///< why a degree of freedom was or was not observed, one sentence each
  int pairs = 0, planar_inliers = 0;
  int height_pairs = 0, height_inliers = 0;
  int axis_pairs = 0, axis_inliers = 0;
  double planar_rms_m = 0.0;            ///< of the inliers, in the plane of the reference
  double height_rms_m = 0.0;
  double axis_median_rad = 0.0;
  double tilt_sd_rad = 0.0;             ///< estimated standard deviation of the worse of roll and pitch
};

/// Full rigid pose from matched stems (method.md 7.3 and 7.4, here for whole surveys). `guess` takes the query to the
/// reference well enough that heights and axes can be compared: a planar pose, with the levelling of both sides undone.
/// x, y, yaw from the pairs' positions; roll and pitch from their axes and from base heights over a wide enough plane;
/// z from base heights. Each is robust (Cauchy weights, scale from the median residual); x and y stay fixed while the tilt
/// is solved. Fewer than two pairs: the guess, nothing observed.
SixDofReport refine_six_dof(std::span<const Stem> reference, std::span<const Stem> query, std::span<const IndexPair> pairs,
                            const RigidTransform& guess, const SixDofSettings& settings = {});

}  // namespace stemwise
