#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/geodesy/georeference.hpp"

namespace stemwise {

/// A point whose place is known both in the reference's frame and on the earth.
struct ControlPoint {
  std::string name;                    ///< "row 3" or the tree's label: for messages
  Eigen::Vector3d in_reference_m = Eigen::Vector3d::Zero();
  bool has_z = false;
  Geodetic on_earth;
  bool has_height = false;
};

struct ControlSettings {
  bool translation_only = false;       ///< keep the azimuth given below, for one point or poor ones
  double azimuth_deg = 0.0;
  double outlier_m = 3.0;              ///< farther than this (and 3 robust sigma) from the consensus: left out
};

struct ControlResidual {
  std::string name;
  double residual_m = 0.0;             ///< planar, against the fit of all
  std::optional<double> leave_one_out_m;  ///< planar, against the fit of the others; needs 3 points
  bool used = true;
};

struct ControlReport {
  Georeference georeference;
  double rms_m = 0.0;                  ///< planar, of the used points
  std::vector<ControlResidual> residuals;
};

/// One level rigid pose (azimuth, easting, northing; height as the median offset) from control points: two are enough.
/// Robust from four on: the pair of points that most others agree with decides which are used. An error issue when there
/// are too few, when they coincide, or when they contradict the distances in the frame by more than a tenth.
Result<ControlReport> solve_control_points(const std::vector<ControlPoint>& points, const ControlSettings& settings);

}  // namespace stemwise
