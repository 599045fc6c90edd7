#include "core/treeloc/align_truths.hpp"

#include <cmath>

#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace stemwise::treeloc {
namespace {

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& r) {
  const Eigen::AngleAxisd a(r);
  return a.angle() * a.axis();
}

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

constexpr double position_sd_m = 0.15;
constexpr double rotation_sd_deg = 0.5;

/// Normal equations of a small turn and shift.
struct Step {
  Eigen::Matrix<double, 6, 6> normal = 1e-9 * Eigen::Matrix<double, 6, 6>::Identity();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
};

/// How far the moved truth of a query is from its estimate, weighted down the farther it is.
void add_query(Step& step, const QueryRow& row, const RigidTransform& moved_from_centered, const Eigen::Vector3d& center) {
  const double rotation_sd = radians(rotation_sd_deg);
  const Eigen::Vector3d turned = moved_from_centered.rotation * (row.true_survey_from_query.translation_m - center);
  const Eigen::Vector3d dp = row.survey_from_query.translation_m - (turned + moved_from_centered.translation_m);
  const Eigen::Vector3d dr = rotation_vector(row.survey_from_query.rotation *
                                             (moved_from_centered.rotation * row.true_survey_from_query.rotation).transpose());
  const double u = dp.squaredNorm() / (position_sd_m * position_sd_m) + dr.squaredNorm() / (rotation_sd * rotation_sd);
  const double weight = 1.0 / (1.0 + u / 9.0);
  Eigen::Matrix<double, 3, 6> jacobian;
  jacobian << -skew(turned), Eigen::Matrix3d::Identity();
  step.normal += weight / (position_sd_m * position_sd_m) * jacobian.transpose() * jacobian;
  step.right += weight / (position_sd_m * position_sd_m) * jacobian.transpose() * dp;
  step.normal.topLeftCorner<3, 3>() += weight / (rotation_sd * rotation_sd) * Eigen::Matrix3d::Identity();
  step.right.head<3>() += weight / (rotation_sd * rotation_sd) * dr;
}

/// moved = turn * (p - center) + center + shift, by robust least squares.
RigidTransform fit_moved_from_centered(const std::vector<QueryRow>& rows, const Eigen::Vector3d& center) {
  RigidTransform moved_from_centered{Eigen::Matrix3d::Identity(), center};
  for (int iteration = 0; iteration < 30; ++iteration) {
    Step step;
    for (const QueryRow& row : rows) {
      if (row.found()) add_query(step, row, moved_from_centered, center);
    }
    const Eigen::Matrix<double, 6, 1> change = step.normal.ldlt().solve(step.right);
    const Eigen::Vector3d turn = change.head<3>();
    if (turn.norm() > 0.0) {
      moved_from_centered.rotation =
          Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * moved_from_centered.rotation;
    }
    moved_from_centered.translation_m += change.tail<3>();
    if (change.norm() < 1e-10) break;
  }
  return moved_from_centered;
}

}  // namespace

void compare_with_moved_truth(std::vector<QueryRow>& rows, const RigidTransform& map_from_query_survey) {
  for (QueryRow& row : rows) {
    if (!row.found()) continue;
    const RigidTransform survey_from_candidate = row.survey_from_query * row.candidate_from_query.inverse();
    compare_with_truth(row, survey_from_candidate.inverse() * map_from_query_survey * row.true_survey_from_query);
  }
}

RigidTransform align_truths(std::vector<QueryRow>& rows) {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (const QueryRow& row : rows) {
    if (row.found()) center += row.true_survey_from_query.translation_m, count += 1.0;
  }
  if (count == 0.0) return {};
  center /= count;
  const RigidTransform moved_from_centered = fit_moved_from_centered(rows, center);
  const RigidTransform map_from_query_survey = moved_from_centered * RigidTransform{Eigen::Matrix3d::Identity(), -center};
  compare_with_moved_truth(rows, map_from_query_survey);
  return map_from_query_survey;
}

}  // namespace stemwise::treeloc
