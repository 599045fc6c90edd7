#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.hpp"

namespace stemwise::treeloc {

/// One tree of a scene. Positions in the scene's aligned frame: origin at the scene's pose, z along the dominant stem axis.
struct SceneTree {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x, y of the stem, z of its base
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();        ///< unit vector upwards; zero where none was measured
  double dbh_m = 0.0;                                    ///< measured, else approximate
  bool has_height = false;
  bool reconstructed = false;
  bool own = true;  ///< of the frame itself, not carried over from a preceding one
  int clusters = 1;
  bool has_axis() const { return axis.squaredNorm() > 0.5; }
};

/// What is described and matched: the trees around one pose (method.md, sections 1 to 3).
struct Scene {
  static constexpr std::size_t most_trees = 255;
  std::int64_t number = 0;           ///< frame number, or running number of a sampled position
  RigidTransform survey_from_scene;  ///< where the scene stands in its survey: the frame's pose, or the sampled position
  Eigen::Matrix3d aligned_from_scene = Eigen::Matrix3d::Identity();  ///< R^A of eq. 1
  bool tilt_observed = false;                                        ///< roll and pitch came from stem axes
  bool level_sensor = false;  ///< a frame of a survey whose sensor was carried at a constant height (sensor_height.hpp)
  double ground_m = 0.0;  ///< base height under the origin in the aligned frame, from the nearest trees
  bool ground_observed = false;
  std::vector<SceneTree> trees;  ///< in order of x: pairing relies on it; at most 255
};

}  // namespace stemwise::treeloc
