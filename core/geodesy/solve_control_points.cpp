#include "core/geodesy/solve_control_points.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {
namespace {

/// A control point in a tangent plane about the points' middle.
struct PlanarPair {
  Eigen::Vector2d frame_m, enu_m;
  double up_m = 0.0;
  bool has_up = false;
};

struct PlanarFit {
  double yaw_rad = 0.0;  ///< enu = R(yaw) frame + shift
  Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d operator*(const Eigen::Vector2d& p) const {
    const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
    return {c * p.x() - s * p.y() + shift_m.x(), s * p.x() + c * p.y() + shift_m.y()};
  }
};

using Indices = std::vector<std::size_t>;

Eigen::Vector2d turned(const Eigen::Vector2d& p, double yaw_rad) { return PlanarFit{yaw_rad, {0, 0}} * p; }

/// Least squares in the plane; the yaw is kept where `fixed_yaw_rad` is given.
PlanarFit fit(const std::vector<PlanarPair>& pairs, const Indices& use, std::optional<double> fixed_yaw_rad) {
  Eigen::Vector2d frame = Eigen::Vector2d::Zero(), enu = Eigen::Vector2d::Zero();
  for (const std::size_t i : use) {
    frame += pairs[i].frame_m;
    enu += pairs[i].enu_m;
  }
  frame /= static_cast<double>(use.size());
  enu /= static_cast<double>(use.size());
  double dot = 0.0, cross = 0.0;
  for (const std::size_t i : use) {
    const Eigen::Vector2d a = pairs[i].frame_m - frame, b = pairs[i].enu_m - enu;
    dot += a.dot(b);
    cross += a.x() * b.y() - a.y() * b.x();
  }
  PlanarFit out;
  out.yaw_rad = fixed_yaw_rad.value_or(std::atan2(cross, dot));
  out.shift_m = enu - turned(frame, out.yaw_rad);
  return out;
}

double residual_m(const PlanarFit& pose, const PlanarPair& pair) { return (pose * pair.frame_m - pair.enu_m).norm(); }

Indices within(const std::vector<PlanarPair>& pairs, const PlanarFit& pose, double limit_m) {
  Indices out;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (residual_m(pose, pairs[i]) <= limit_m) out.push_back(i);
  return out;
}

Indices all_of(std::size_t count) {
  Indices all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = i;
  return all;
}

/// The points that the best pair's pose brings home; every pair is tried (control points are few).
Indices consensus(const std::vector<PlanarPair>& pairs, const ControlSettings& settings, std::optional<double> yaw_rad) {
  if (pairs.size() < 4) return all_of(pairs.size());
  Indices best;
  double best_sum = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = i + 1; j < pairs.size(); ++j) {
      const PlanarFit pose = fit(pairs, {i, j}, yaw_rad);
      const Indices inside = within(pairs, pose, settings.outlier_m);
      double sum = 0.0;
      for (const std::size_t k : inside) sum += residual_m(pose, pairs[k]);
      if (inside.size() > best.size() || (inside.size() == best.size() && sum < best_sum)) {
        best = inside;
        best_sum = sum;
      }
    }
  const PlanarFit pose = fit(pairs, best, yaw_rad);
  std::vector<double> residuals;
  for (const std::size_t k : best) residuals.push_back(residual_m(pose, pairs[k]));
  return within(pairs, pose, std::max(settings.outlier_m, 3.0 * 1.4826 * median(residuals)));
}

Geodetic middle(const std::vector<ControlPoint>& points) {
  Geodetic out;
  for (const ControlPoint& point : points) {
    out.latitude_deg += point.on_earth.latitude_deg / static_cast<double>(points.size());
    out.longitude_deg += point.on_earth.longitude_deg / static_cast<double>(points.size());
  }
  return out;
}

Eigen::Vector3d middle_in_reference(const std::vector<ControlPoint>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const ControlPoint& point : points) sum += point.in_reference_m;
  return {sum.x() / static_cast<double>(points.size()), sum.y() / static_cast<double>(points.size()), 0.0};
}

std::vector<PlanarPair> planar_pairs(const std::vector<ControlPoint>& points, const Georeference& plane) {
  std::vector<PlanarPair> pairs;
  for (const ControlPoint& point : points) {
    const Eigen::Vector3d enu = reference_from_geodetic(plane, point.on_earth);
    pairs.push_back({(point.in_reference_m - middle_in_reference(points)).head<2>(), enu.head<2>(),
                     enu.z() - (point.has_z ? point.in_reference_m.z() : 0.0), point.has_height});
  }
  return pairs;
}

std::optional<Issue> check(const std::vector<ControlPoint>& points, const std::vector<PlanarPair>& pairs, bool translation_only) {
  const std::size_t needed = translation_only ? 1 : 2;
  if (points.size() < needed)
    return Issue{Severity::error, "", 0, "", std::to_string(points.size()) + " control points, at least 2 are needed",
                 "one is enough when the azimuth is given"};
  if (translation_only) return std::nullopt;
  double longest_m = 0.0, ratio = 1.0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = i + 1; j < pairs.size(); ++j) {
      const double frame_m = (pairs[i].frame_m - pairs[j].frame_m).norm();
      if (frame_m <= longest_m) continue;
      longest_m = frame_m;
      ratio = (pairs[i].enu_m - pairs[j].enu_m).norm() / frame_m;
    }
  if (longest_m < 1.0) return Issue{Severity::error, "", 0, "", "the control points lie on one spot", "take points far apart"};
  if (points.size() == 2 && std::abs(ratio - 1.0) > 0.1)
    return Issue{Severity::error, "", 0, "", "the two control points are " + std::to_string(ratio) + " times as far apart on the earth as in the survey",
                 "check which point is which, and the order of longitude and latitude"};
  return std::nullopt;
}

void set_height(Georeference& out, const std::vector<PlanarPair>& pairs, const Indices& used) {
  std::vector<double> up;
  for (const std::size_t i : used)
    if (pairs[i].has_up) up.push_back(pairs[i].up_m);
  if (!up.empty()) out.origin.height_m += median(up);
}

ControlReport report(const std::vector<ControlPoint>& points, const std::vector<PlanarPair>& pairs, const Indices& used,
                     const PlanarFit& pose, std::optional<double> yaw_rad) {
  ControlReport out;
  double sum_sq = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ControlResidual row{points[i].name, residual_m(pose, pairs[i]), std::nullopt, std::find(used.begin(), used.end(), i) != used.end()};
    Indices others = used;
    std::erase(others, i);
    if (others.size() >= 2) row.leave_one_out_m = residual_m(fit(pairs, others, yaw_rad), pairs[i]);
    if (row.used) sum_sq += row.residual_m * row.residual_m;
    out.residuals.push_back(std::move(row));
  }
  out.rms_m = std::sqrt(sum_sq / static_cast<double>(used.size()));
  return out;
}

}  // namespace

Result<ControlReport> solve_control_points(const std::vector<ControlPoint>& points, const ControlSettings& settings) {
  if (points.empty()) return Result<ControlReport>::failure({Severity::error, "", 0, "", "no control points", ""});
  Georeference plane;
  plane.kind = GeoreferenceKind::anchor;
  plane.origin = middle(points);
  const std::vector<PlanarPair> pairs = planar_pairs(points, plane);
  if (auto issue = check(points, pairs, settings.translation_only)) return Result<ControlReport>::failure(*issue);
  std::optional<double> yaw_rad;
  if (settings.translation_only) yaw_rad.emplace(-radians(settings.azimuth_deg));
  const Indices used = consensus(pairs, settings, yaw_rad);
  const PlanarFit pose = fit(pairs, used, yaw_rad);
  ControlReport out = report(points, pairs, used, pose, yaw_rad);
  Georeference& georeference = out.georeference;
  georeference = plane;
  georeference.origin = geodetic_from_reference(plane, {pose.shift_m.x(), pose.shift_m.y(), 0.0});
  georeference.origin.height_m = 0.0;
  georeference.anchored_point_m = middle_in_reference(points);
  georeference.azimuth_deg = std::fmod(degrees(-pose.yaw_rad) + 720.0, 360.0);
  set_height(georeference, pairs, used);
  georeference.sd_m = out.rms_m;
  georeference.method = "control points (" + std::to_string(used.size()) + ")";
  return out;
}

}  // namespace stemwise
