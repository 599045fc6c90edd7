#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/rigid_transform.hpp"

namespace stemwise {

/// What one measurement says about the relative pose of two nodes, and how well: standard deviations along a's own axes. A
/// bare list in the plane says nothing about height and tilt: large values there.
struct PoseEdge {
  std::size_t a = 0, b = 0;
  RigidTransform a_from_b;
  double position_sd_m = 0.1;  ///< x and y
  double height_sd_m = 0.1;
  double yaw_sd_rad = 0.01;
  double tilt_sd_rad = 0.01;   ///< roll and pitch
  bool trusted = false;        ///< odometry: no robust kernel, never rejected
};

struct PoseGraphSettings {
  double kernel_sds = 2.0;      ///< scale of the Cauchy kernel
  bool graduated = true;        ///< approached from a kernel so wide that everything pulls; not needed near the solution
  double reject_sds = 6.0;      ///< an edge farther off than this many standard deviations is rejected
  double reject_m = 0.5;        ///< and only when it is off by this much
  int most_iterations = 60;
};

struct PoseGraphReport {
  std::vector<RigidTransform> poses;   ///< per node
  std::vector<char> accepted;          ///< per edge
  std::vector<double> residual_m;      ///< per edge: planar
  std::vector<std::size_t> group;      ///< per node: nodes that accepted edges connect have the same; 0 is the anchor's
  bool converged = false;
};

/// Poses that agree best with all edges (nonlinear least squares with Ceres; Grisetti et al. 2010, "A tutorial on graph-based
/// SLAM"): robust kernel on the untrusted ones, tightened in steps so that far-off but right loop closures pull before wrong
/// ones are let go. `anchor` keeps its pose; so does one node of every group that nothing connects to it. Deterministic.
PoseGraphReport optimise_pose_graph(std::vector<RigidTransform> start, std::span<const PoseEdge> edges, std::size_t anchor,
                                    const PoseGraphSettings& settings = {});

}  // namespace stemwise
