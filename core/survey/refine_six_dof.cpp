#include "core/survey/refine_six_dof.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

namespace stemwise {
namespace {

/// One pair about the middle of the pairs (UTM-sized numbers lose nothing). `query` is in the query's frame about its own middle.
struct Centred {
  Eigen::Vector3d reference = Eigen::Vector3d::Zero();
  Eigen::Vector3d query = Eigen::Vector3d::Zero();
  bool has_heights = false;
  std::optional<Eigen::Vector3d> reference_axis, query_axis;
};

struct Problem {
  std::vector<Centred> pairs;
  Eigen::Vector3d reference_middle = Eigen::Vector3d::Zero(), query_middle = Eigen::Vector3d::Zero();
};

/// reference (centred) = rotation * query (centred) + shift.
struct CentredPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  Eigen::Vector3d operator()(const Eigen::Vector3d& query) const { return rotation * query + shift; }
};

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Eigen::Vector3d position(const Stem& stem) { return {stem.x_m, stem.y_m, stem.z_m.value_or(0.0)}; }

/// Middle of the pairs by medians; of the heights, those that are known.
Eigen::Vector3d middle_of(const std::vector<const Stem*>& stems) {
  std::vector<double> x, y, z;
  for (const Stem* stem : stems) {
    x.push_back(stem->x_m);
    y.push_back(stem->y_m);
    if (stem->z_m) z.push_back(*stem->z_m);
  }
  return {median(x), median(y), median(z)};
}

Problem centre(std::span<const Stem> reference, std::span<const Stem> query, std::span<const IndexPair> pairs) {
  std::vector<const Stem*> a, b;
  for (const IndexPair& pair : pairs) {
    a.push_back(&reference[pair.reference]);
    b.push_back(&query[pair.query]);
  }
  Problem problem;
  problem.reference_middle = middle_of(a);
  problem.query_middle = middle_of(b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    Centred c{position(*a[i]) - problem.reference_middle, position(*b[i]) - problem.query_middle, a[i]->z_m && b[i]->z_m, {}, {}};
    if (a[i]->axis && b[i]->axis) {
      c.reference_axis = a[i]->axis->normalized();
      c.query_axis = b[i]->axis->normalized();
    }
    if (!a[i]->z_m) c.reference.z() = 0.0;
    if (!b[i]->z_m) c.query.z() = 0.0;
    problem.pairs.push_back(c);
  }
  return problem;
}

double cauchy(double residual, double scale) { return 1.0 / (1.0 + (residual / scale) * (residual / scale)); }

/// x, y and yaw by reweighted least squares (method.md 7.1), about +z of the reference; tilt and height stay.
void solve_planar(const Problem& problem, const SixDofSettings& settings, CentredPose& pose) {
  std::vector<double> distances;
  for (const Centred& c : problem.pairs) distances.push_back((pose(c.query) - c.reference).head<2>().norm());
  const double scale = std::max(settings.planar_floor_m, 2.5 * median(distances));
  double total = 0.0;
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
  std::vector<double> weights;
  for (std::size_t i = 0; i < problem.pairs.size(); ++i) {
    weights.push_back(cauchy(distances[i], scale));
    from += weights[i] * pose(problem.pairs[i].query).head<2>();
    to += weights[i] * problem.pairs[i].reference.head<2>();
    total += weights[i];
  }
  from /= total;
  to /= total;
  double sine = 0.0, cosine = 0.0;
  for (std::size_t i = 0; i < problem.pairs.size(); ++i) {
    const Eigen::Vector2d a = pose(problem.pairs[i].query).head<2>() - from, b = problem.pairs[i].reference.head<2>() - to;
    sine += weights[i] * (a.x() * b.y() - a.y() * b.x());
    cosine += weights[i] * a.dot(b);
  }
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(std::atan2(sine, cosine), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.rotation = turn * pose.rotation;
  const Eigen::Vector2d shift = turn.topLeftCorner<2, 2>() * (pose.shift.head<2>() - from) + to;
  pose.shift.head<2>() = shift;
}

/// What one kind of data says about a small tilt (rotation vector x, y) in normal equations, its systematic error included.
struct TiltEvidence {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  int count = 0, inliers = 0;
  double scale = 0.0;
};

/// Many trees do not average away what they have in common: no eigenvalue of the information exceeds 1 / bias^2.
void limit_information(TiltEvidence& evidence, double bias_rad) {
  const Eigen::Vector2d largest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(evidence.information).eigenvalues();
  const double limit = 1.0 / (bias_rad * bias_rad);
  if (largest(1) <= limit) return;
  evidence.right *= limit / largest(1);
  evidence.information *= limit / largest(1);
}

/// Axis residual: the two planar components of (turned query axis - reference axis), signs made equal.
TiltEvidence tilt_from_axes(const Problem& problem, const SixDofSettings& settings, const CentredPose& pose) {
  struct Row {
    Eigen::Vector3d turned, residual;
  };
  std::vector<Row> rows;
  std::vector<double> sizes;
  for (const Centred& c : problem.pairs) {
    if (!c.reference_axis) continue;
    const Eigen::Vector3d turned = pose.rotation * *c.query_axis;
    const Eigen::Vector3d target = turned.dot(*c.reference_axis) < 0.0 ? Eigen::Vector3d(-*c.reference_axis) : *c.reference_axis;
    rows.push_back({turned, target - turned});
    sizes.push_back(rows.back().residual.norm());
  }
  TiltEvidence evidence;
  evidence.count = static_cast<int>(rows.size());
  evidence.scale = std::max(radians(settings.axis_floor_deg), median(sizes));
  for (const Row& row : rows) {  // turned + omega x turned, omega = (x, y, 0)
    const double weight = cauchy(row.residual.norm(), 1.5 * evidence.scale) / (evidence.scale * evidence.scale);
    Eigen::Matrix<double, 3, 2> jacobian;
    jacobian.col(0) = Eigen::Vector3d::UnitX().cross(row.turned);
    jacobian.col(1) = Eigen::Vector3d::UnitY().cross(row.turned);
    evidence.information += weight * jacobian.transpose() * jacobian;
    evidence.right += weight * jacobian.transpose() * row.residual;
    evidence.inliers += row.residual.norm() <= 3.0 * evidence.scale ? 1 : 0;
  }
  limit_information(evidence, radians(settings.axis_bias_deg));
  return evidence;
}

struct HeightRow {
  Eigen::Vector2d at;  ///< where the turned query stem is, about the middle
  double residual;     ///< reference height - height of the turned query stem
};

std::vector<HeightRow> height_rows(const Problem& problem, const CentredPose& pose) {
  std::vector<HeightRow> rows;
  for (const Centred& c : problem.pairs) {
    if (!c.has_heights) continue;
    const Eigen::Vector3d at = pose(c.query);
    rows.push_back({at.head<2>(), c.reference.z() - at.z()});
  }
  return rows;
}

double median_residual(const std::vector<HeightRow>& rows) {
  std::vector<double> residuals;
  for (const HeightRow& row : rows) residuals.push_back(row.residual);
  return median(residuals);
}

/// z' ~ z - psi x + phi y on base heights (method.md 7.4); the mean offset is eliminated, so that only the tilt is left.
TiltEvidence tilt_from_heights(std::vector<HeightRow> rows, const SixDofSettings& settings) {
  TiltEvidence evidence;
  evidence.count = static_cast<int>(rows.size());
  if (rows.size() < 3) return evidence;
  const double offset = median_residual(rows);
  std::vector<double> sizes;
  for (const HeightRow& row : rows) sizes.push_back(std::abs(row.residual - offset));
  evidence.scale = std::max(settings.height_floor_m, 1.5 * median(sizes));
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const HeightRow& row : rows) {
    const Eigen::Vector3d j(row.at.y(), -row.at.x(), 1.0);
    const double weight = cauchy(row.residual - offset, 1.5 * evidence.scale) / (evidence.scale * evidence.scale);
    normal += weight * j * j.transpose();
    right += weight * j * (row.residual - offset);
    evidence.inliers += std::abs(row.residual - offset) <= 3.0 * evidence.scale ? 1 : 0;
  }
  const Eigen::Vector2d mixed = normal.topRightCorner<2, 1>();
  evidence.information = normal.topLeftCorner<2, 2>() - mixed * mixed.transpose() / normal(2, 2);
  evidence.right = right.head<2>() - mixed * right(2) / normal(2, 2);
  // a smooth bias over the plane's width looks like a tilt: width^2 = information / weight
  const double width = std::sqrt(std::max(1e-12, evidence.information.norm() * evidence.scale * evidence.scale / evidence.count));
  limit_information(evidence, settings.height_bias_m / width);
  return evidence;
}

/// Robust mean of the height residuals; nothing when too few pairs have heights.
void solve_height(const Problem& problem, const SixDofSettings& settings, CentredPose& pose) {
  const std::vector<HeightRow> rows = height_rows(problem, pose);
  if (rows.empty()) return;
  double offset = median_residual(rows);
  for (int round = 0; round < 5; ++round) {
    std::vector<double> sizes;
    for (const HeightRow& row : rows) sizes.push_back(std::abs(row.residual - offset));
    const double scale = std::max(settings.height_floor_m, 1.5 * median(sizes));
    double sum = 0.0, total = 0.0;
    for (const HeightRow& row : rows) {
      const double weight = cauchy(row.residual - offset, scale);
      sum += weight * row.residual;
      total += weight;
    }
    offset = sum / total;
  }
  pose.shift.z() += offset;
}

struct Tilt {
  bool observed = false, by_axes = false, by_heights = false;  ///< which evidence was used
  double sd_rad = 0.0;
  TiltEvidence axes, heights;
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
};

Tilt weigh_tilt(const Problem& problem, const SixDofSettings& settings, const CentredPose& pose) {
  Tilt tilt;
  tilt.axes = tilt_from_axes(problem, settings, pose);
  tilt.heights = tilt_from_heights(height_rows(problem, pose), settings);
  tilt.by_axes = tilt.axes.inliers >= settings.least_axes && 2 * tilt.axes.inliers >= tilt.axes.count;
  tilt.by_heights = tilt.heights.inliers >= std::max(4, settings.least_heights) && 2 * tilt.heights.inliers >= tilt.heights.count;
  if (tilt.by_axes) {
    tilt.information += tilt.axes.information;
    tilt.right += tilt.axes.right;
  }
  if (tilt.by_heights) {
    tilt.information += tilt.heights.information;
    tilt.right += tilt.heights.right;
  }
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(tilt.information).eigenvalues()(0);
  tilt.observed = least >= 1.0 / std::pow(radians(settings.tilt_tolerance_deg), 2);
  tilt.sd_rad = least > 0.0 ? 1.0 / std::sqrt(least) : 0.0;
  return tilt;
}

/// One step of roll and pitch about the middle of the pairs, x and y of the middle kept fixed.
void step_tilt(const Tilt& tilt, CentredPose& pose) {
  const Eigen::Vector2d step = tilt.information.inverse() * tilt.right;
  const Eigen::Vector3d omega(step.x(), step.y(), 0.0);
  if (omega.norm() < 1e-12) return;
  pose.rotation = Eigen::AngleAxisd(omega.norm(), omega.normalized()).toRotationMatrix() * pose.rotation;
}

void drop_tilt(CentredPose& pose) {
  const double yaw_rad = roll_pitch_yaw(pose.rotation).yaw_rad;
  pose.rotation = rotation_from({0.0, 0.0, yaw_rad});
}

RigidTransform uncentred(const Problem& problem, const CentredPose& pose) {
  return {pose.rotation, problem.reference_middle + pose.shift - pose.rotation * problem.query_middle};
}

void count_planar(const Problem& problem, const SixDofSettings& settings, const CentredPose& pose, SixDofReport& report) {
  std::vector<double> distances;
  for (const Centred& c : problem.pairs) distances.push_back((pose(c.query) - c.reference).head<2>().norm());
  const double limit = 3.0 * std::max(settings.planar_floor_m, median(distances));
  double sum = 0.0;
  for (const double d : distances)
    if (d <= limit) {
      ++report.planar_inliers;
      sum += d * d;
    }
  if (report.planar_inliers > 0) report.planar_rms_m = std::sqrt(sum / report.planar_inliers);
}

void count_heights(const Problem& problem, const SixDofSettings& settings, const CentredPose& pose, SixDofReport& report) {
  const std::vector<HeightRow> rows = height_rows(problem, pose);
  std::vector<double> sizes;
  for (const HeightRow& row : rows) sizes.push_back(std::abs(row.residual));
  const double limit = 3.0 * std::max(settings.height_floor_m, 1.5 * median(sizes));
  double sum = 0.0;
  report.height_pairs = static_cast<int>(rows.size());
  for (const double s : sizes)
    if (s <= limit) {
      ++report.height_inliers;
      sum += s * s;
    }
  if (report.height_inliers > 0) report.height_rms_m = std::sqrt(sum / report.height_inliers);
}

void explain(const Tilt& tilt, bool height, const SixDofSettings& settings, SixDofReport& report) {
  const auto number = [](double v) {
    std::string text = std::to_string(v);
    return text.substr(0, text.find('.') + 3);
  };
  report.notes.push_back("x, y and yaw come from " + std::to_string(report.planar_inliers) + " of " + std::to_string(report.pairs) +
                         " pairs of stems that agree.");
  if (height)
    report.notes.push_back("z comes from the base heights of " + std::to_string(report.height_inliers) + " pairs.");
  else
    report.notes.push_back("z was not observed: " + std::to_string(report.height_pairs) + " pairs have base heights on both sides, " +
                           std::to_string(settings.least_heights) + " that agree are needed.");
  if (tilt.observed)
    report.notes.push_back("roll and pitch come from " + std::string(tilt.by_axes ? std::to_string(tilt.axes.inliers) + " stem axes" : "") +
                           (tilt.by_axes && tilt.by_heights ? " and " : "") +
                           (tilt.by_heights ? std::to_string(tilt.heights.inliers) + " base heights" : std::string()) + ", to " +
                           number(degrees(tilt.sd_rad)) + " degrees.");
  else
    report.notes.push_back("roll and pitch were not observed: " + std::to_string(tilt.axes.inliers) + " pairs of stem axes agree, and " +
                           std::to_string(tilt.heights.inliers) + " base heights do not span a wide enough plane.");
}

}  // namespace

Fields SixDofSettings::fields() {
  return {{"six_dof.planar_floor_m", "m", "Position differences are never trusted to better than this.", &planar_floor_m},
          {"six_dof.height_floor_m", "m", "Base height differences are never trusted to better than this.", &height_floor_m},
          {"six_dof.axis_floor_deg", "deg", "Axis differences are never trusted to better than this.", &axis_floor_deg},
          {"six_dof.height_bias_m", "m", "Smooth error of base heights that more trees do not average away.", &height_bias_m},
          {"six_dof.axis_bias_deg", "deg", "Common error of stem axes that more trees do not average away.", &axis_bias_deg},
          {"six_dof.tilt_tolerance_deg", "deg", "Roll and pitch count as observed when known to better than this.", &tilt_tolerance_deg},
          {"six_dof.least_heights", "", "Agreeing pairs with base heights needed for z.", &least_heights},
          {"six_dof.least_axes", "", "Agreeing pairs with axes needed for roll and pitch.", &least_axes},
          {"six_dof.rounds", "", "Rounds of planar, tilt and height.", &rounds}};
}

SixDofReport refine_six_dof(std::span<const Stem> reference, std::span<const Stem> query, std::span<const IndexPair> pairs,
                            const RigidTransform& guess, const SixDofSettings& settings) {
  SixDofReport report;
  report.pairs = static_cast<int>(pairs.size());
  report.reference_from_query = guess;
  if (pairs.size() < 2) {
    report.notes.push_back("nothing was observed: fewer than two pairs of stems.");
    return report;
  }
  const Problem problem = centre(reference, query, pairs);
  CentredPose pose{guess.rotation, guess * problem.query_middle - problem.reference_middle};
  for (int round = 0; round < settings.rounds; ++round) {
    solve_planar(problem, settings, pose);
    solve_height(problem, settings, pose);
    const Tilt tilt = weigh_tilt(problem, settings, pose);
    if (tilt.observed)
      step_tilt(tilt, pose);
    else
      drop_tilt(pose);
  }
  solve_planar(problem, settings, pose);
  solve_height(problem, settings, pose);
  count_planar(problem, settings, pose, report);
  count_heights(problem, settings, pose, report);
  const Tilt tilt = weigh_tilt(problem, settings, pose);
  const bool height = report.height_inliers >= settings.least_heights;
  report.axis_pairs = tilt.axes.count;
  report.axis_inliers = tilt.axes.inliers;
  report.axis_median_rad = tilt.axes.scale;
  report.tilt_sd_rad = tilt.observed ? tilt.sd_rad : 0.0;
  for (const Dof dof : {Dof::x, Dof::y, Dof::yaw}) report.observed.set(dof, report.planar_inliers >= 2);
  report.observed.set(Dof::z, height);
  report.observed.set(Dof::roll, tilt.observed);
  report.observed.set(Dof::pitch, tilt.observed);
  report.reference_from_query = uncentred(problem, pose);
  if (!height) report.reference_from_query.translation_m.z() = 0.0;
  explain(tilt, height, settings, report);
  return report;
}

}  // namespace stemwise
