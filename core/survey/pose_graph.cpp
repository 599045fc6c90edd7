#include "core/survey/pose_graph.hpp"

#include <ceres/ceres.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace stemwise {
namespace {

/// Seven numbers of a node as Ceres wants them: quaternion x y z w, translation.
struct Node {
  std::array<double, 4> turn{};
  std::array<double, 3> place{};
};

Node node_of(const RigidTransform& pose) {
  const Eigen::Quaterniond q(pose.rotation);
  return {{q.x(), q.y(), q.z(), q.w()}, {pose.translation_m.x(), pose.translation_m.y(), pose.translation_m.z()}};
}

RigidTransform pose_of(const Node& node) {
  const Eigen::Quaterniond q(node.turn[3], node.turn[0], node.turn[1], node.turn[2]);
  return {q.normalized().toRotationMatrix(), {node.place[0], node.place[1], node.place[2]}};
}

/// Where and how a sees b, less how it should: along a's axes, in standard deviations.
struct EdgeResidual {
  explicit EdgeResidual(const PoseEdge& edge)
      : place(edge.a_from_b.translation_m),
        turn(Eigen::Quaterniond(edge.a_from_b.rotation)),
        weight((Eigen::Matrix<double, 6, 1>() << 1.0 / edge.position_sd_m, 1.0 / edge.position_sd_m, 1.0 / edge.height_sd_m, 1.0 / edge.tilt_sd_rad,
                1.0 / edge.tilt_sd_rad, 1.0 / edge.yaw_sd_rad)
                   .finished()) {}

  template <class T>
  bool operator()(const T* turn_a, const T* place_a, const T* turn_b, const T* place_b, T* residual) const {
    const Eigen::Map<const Eigen::Quaternion<T>> qa(turn_a), qb(turn_b);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> ta(place_a), tb(place_b);
    const Eigen::Quaternion<T> inverse_a = qa.conjugate();
    const Eigen::Matrix<T, 3, 1> off = inverse_a * (tb - ta) - place.cast<T>();
    const Eigen::Quaternion<T> turned = inverse_a * qb * turn.cast<T>().conjugate();
    const T sign = turned.w() < T(0.0) ? T(-2.0) : T(2.0);  // q and -q are one rotation
    Eigen::Map<Eigen::Matrix<T, 6, 1>> out(residual);
    out.template head<3>() = off;
    out.template tail<3>() = sign * turned.vec();
    out = out.cwiseProduct(weight.cast<T>());
    return true;
  }

  Eigen::Vector3d place;
  Eigen::Quaterniond turn;
  Eigen::Matrix<double, 6, 1> weight;
};

double off_in_sds(const PoseEdge& edge, const RigidTransform& a, const RigidTransform& b) {
  const Node na = node_of(a), nb = node_of(b);
  Eigen::Matrix<double, 6, 1> residual;
  const EdgeResidual off(edge);
  off(na.turn.data(), na.place.data(), nb.turn.data(), nb.place.data(), residual.data());
  return residual.norm();
}

/// The smallest node of each connected part, per node; the anchor's part is numbered by the anchor.
std::vector<std::size_t> parts_of(std::size_t nodes, std::span<const PoseEdge> edges, const std::vector<char>& used, std::size_t anchor) {
  std::vector<std::size_t> parent(nodes);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (used[e] == 0) continue;
    const std::size_t a = root(edges[e].a), b = root(edges[e].b);
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::size_t> part(nodes);
  for (std::size_t i = 0; i < nodes; ++i) part[i] = root(i) == root(anchor) ? anchor : root(i);
  return part;
}

bool solve(std::vector<Node>& nodes, std::span<const PoseEdge> edges, const std::vector<char>& used, std::size_t anchor, double kernel_sds, int most_iterations) {
  ceres::Problem::Options options;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::EigenQuaternionManifold sphere;
  ceres::Problem problem(options);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (used[e] == 0 || edges[e].a == edges[e].b) continue;  // of a node with itself: says nothing
    Node &a = nodes[edges[e].a], &b = nodes[edges[e].b];
    auto* cost = new ceres::AutoDiffCostFunction<EdgeResidual, 6, 4, 3, 4, 3>(new EdgeResidual(edges[e]));
    problem.AddResidualBlock(cost, edges[e].trusted ? nullptr : new ceres::CauchyLoss(kernel_sds), a.turn.data(), a.place.data(), b.turn.data(), b.place.data());
    problem.SetManifold(a.turn.data(), &sphere);
    problem.SetManifold(b.turn.data(), &sphere);
  }
  const std::vector<std::size_t> part = parts_of(nodes.size(), edges, used, anchor);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (part[i] != i || !problem.HasParameterBlock(nodes[i].turn.data())) continue;  // one node of every part stays
    problem.SetParameterBlockConstant(nodes[i].turn.data());
    problem.SetParameterBlockConstant(nodes[i].place.data());
  }
  if (problem.NumResidualBlocks() == 0) return true;
  ceres::Solver::Options how;
  how.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  how.max_num_iterations = most_iterations;
  how.num_threads = 1;  // the same bytes at any number of threads
  how.logging_type = ceres::SILENT;
  how.function_tolerance = 1e-7;
  ceres::Solver::Summary summary;
  ceres::Solve(how, &problem, &summary);
  return summary.termination_type == ceres::CONVERGENCE;
}

}  // namespace

PoseGraphReport optimise_pose_graph(std::vector<RigidTransform> start, std::span<const PoseEdge> edges, std::size_t anchor, const PoseGraphSettings& settings) {
  PoseGraphReport report;
  std::vector<Node> nodes;
  for (const RigidTransform& pose : start) nodes.push_back(node_of(pose));
  report.accepted.assign(edges.size(), 1);
  report.residual_m.assign(edges.size(), 0.0);
  const std::vector<double> stages = settings.graduated ? std::vector<double>{256.0, 32.0, 8.0, 1.0, 1.0} : std::vector<double>{1.0, 1.0};
  for (const double wider : stages) {
    report.converged = solve(nodes, edges, report.accepted, anchor, wider * settings.kernel_sds, settings.most_iterations);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const RigidTransform a = pose_of(nodes[edges[e].a]), b = pose_of(nodes[edges[e].b]);
      report.residual_m[e] = ((a.inverse() * b).translation_m - edges[e].a_from_b.translation_m).head<2>().norm();
      const bool off = report.residual_m[e] > settings.reject_m && off_in_sds(edges[e], a, b) > settings.reject_sds;
      report.accepted[e] = wider > 1.0 || edges[e].trusted || !off ? 1 : 0;
    }
  }
  for (const Node& node : nodes) report.poses.push_back(pose_of(node));
  report.group = parts_of(nodes.size(), edges, report.accepted, anchor);
  for (std::size_t& g : report.group) g = g == anchor ? 0 : g + 1;
  return report;
}

}  // namespace stemwise
