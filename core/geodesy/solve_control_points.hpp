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
  Geodetic on_earth;                   ///< height above the ellipsoid
  bool has_height = false;
};

/// Whether the frame's z is taken for the vertical. `automatic`: tilted only where at least four used points with heights say so
/// clearly (heights then fit three times better, and the tilt is more than three of its standard deviations).
enum class LevelChoice { automatic, level, tilted };

struct ControlSettings {
  bool translation_only = false;       ///< keep the azimuth given below, for one point or poor ones
  double azimuth_deg = 0.0;            ///< of the frame's +y axis, clockwise from true north
  double outlier_m = 3.0;              ///< farther than this (and 3 robust sigma) from the consensus: left out
  LevelChoice level = LevelChoice::automatic;
};

struct ControlReport {
  Georeference georeference;           ///< with the residuals
  double rms_m = 0.0;                  ///< planar, of the used points
  std::optional<double> height_rms_m;  ///< of the used points with heights; needs two
  bool tilted = false;
};

/// The rigid pose of the reference's frame on the earth from control points: two are enough when it is level, three with
/// heights when it is not, one when the azimuth is given. Robust from four on: the pair of points that most others agree with
/// decides which are used. An error issue when there are too few, when they coincide or stand on one line (tilted), or when
/// two contradict the distance in the frame by more than a tenth; a warning for every point left out.
Result<ControlReport> solve_control_points(const std::vector<ControlPoint>& points, const ControlSettings& settings);

}  // namespace stemwise
