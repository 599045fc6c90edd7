#include "core/geodesy/solve_control_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/quantile.hpp"
#include "core/geodesy/earth_fit.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {
namespace {

using Pairs = std::vector<EarthPair>;
using Indices = std::vector<std::size_t>;

Pairs chosen(const Pairs& pairs, const Indices& use) {
  Pairs out;
  for (const std::size_t i : use) out.push_back(pairs[i]);
  return out;
}

Indices within(const Pairs& pairs, const EarthFit& fit, double limit_m) {
  Indices out;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (planar_residual_m(fit, pairs[i]) <= limit_m) out.push_back(i);
  return out;
}

Indices all_of(std::size_t count) {
  Indices all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = i;
  return all;
}

/// The points that the best pair's pose brings home; every pair is tried (control points are few).
Indices consensus(const Pairs& pairs, const ControlSettings& settings, std::optional<double> fixed_yaw_rad) {
  if (pairs.size() < 4) return all_of(pairs.size());
  Indices best;
  double best_sum = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = i + 1; j < pairs.size(); ++j) {
      const EarthFit fit = fit_level({pairs[i], pairs[j]}, fixed_yaw_rad);
      const Indices inside = within(pairs, fit, settings.outlier_m);
      double sum = 0.0;
      for (const std::size_t k : inside) sum += planar_residual_m(fit, pairs[k]);
      if (inside.size() > best.size() || (inside.size() == best.size() && sum < best_sum)) {
        best = inside;
        best_sum = sum;
      }
    }
  const EarthFit fit = fit_level(chosen(pairs, best), fixed_yaw_rad);
  std::vector<double> residuals;
  for (const std::size_t k : best) residuals.push_back(planar_residual_m(fit, pairs[k]));
  return within(pairs, fit, std::max(settings.outlier_m, 3.0 * 1.4826 * median(residuals)));
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

Pairs pairs_of(const std::vector<ControlPoint>& points, const Georeference& plane) {
  Pairs pairs;
  const Eigen::Vector3d middle_m = middle_in_reference(points);
  for (const ControlPoint& point : points) {
    EarthPair pair{point.in_reference_m - middle_m, reference_from_geodetic(plane, point.on_earth), point.has_height, 1.0};
    if (!point.has_z) pair.frame_m.z() = 0.0;
    pairs.push_back(pair);
  }
  return pairs;
}

Issue error(std::string text, std::string help) { return {Severity::error, "", 0, "", std::move(text), std::move(help)}; }

std::optional<Issue> check(const Pairs& pairs, bool translation_only) {
  const std::size_t needed = translation_only ? 1 : 2;
  if (pairs.size() < needed)
    return error(std::to_string(pairs.size()) + " control points, at least 2 are needed", "one is enough when the azimuth is given (--translation-only --azimuth)");
  if (translation_only) return std::nullopt;
  double longest_m = 0.0, ratio = 1.0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = i + 1; j < pairs.size(); ++j) {
      const double frame_m = (pairs[i].frame_m - pairs[j].frame_m).head<2>().norm();
      if (frame_m <= longest_m) continue;
      longest_m = frame_m;
      ratio = (pairs[i].enu_m - pairs[j].enu_m).head<2>().norm() / frame_m;
    }
  if (longest_m < 1.0) return error("the control points lie on one spot", "take points far apart");
  if (pairs.size() == 2 && std::abs(ratio - 1.0) > 0.1)
    return error("the two control points are " + std::to_string(ratio) + " times as far apart on the earth as in the survey",
                 "check which point is which, and the order of longitude and latitude");
  return std::nullopt;
}

/// Three or more, with heights, and not on one line: the smaller spread across is at least a metre.
bool can_tilt(const Pairs& pairs) {
  if (pairs.size() < 3 || !std::all_of(pairs.begin(), pairs.end(), [](const EarthPair& p) { return p.has_up; })) return false;
  double widest_m = 0.0;
  for (const EarthPair& a : pairs)
    for (const EarthPair& b : pairs) {
      const Eigen::Vector2d along = (b.frame_m - a.frame_m).head<2>();
      if (along.norm() < 1.0) continue;
      for (const EarthPair& c : pairs) {
        const Eigen::Vector2d across = (c.frame_m - a.frame_m).head<2>();
        widest_m = std::max(widest_m, std::abs(along.x() * across.y() - along.y() * across.x()) / along.norm());
      }
    }
  return widest_m >= 1.0;
}

std::optional<double> height_rms_m(const EarthFit& fit, const Pairs& pairs) {
  double sum_sq = 0.0;
  int known = 0;
  for (const EarthPair& pair : pairs)
    if (pair.has_up) {
      const double off_m = (fit * pair.frame_m - pair.enu_m).z();
      sum_sq += off_m * off_m;
      ++known;
    }
  if (known < 2) return std::nullopt;
  return std::sqrt(sum_sq / known);
}

/// `automatic`: heights must fit three times better with a tilt than without, and it must be a tilt to speak of.
bool says_tilted(const EarthFit& level, const EarthFit& tilted, const Pairs& pairs) {
  if (pairs.size() < 4) return false;
  const double level_rms_m = height_rms_m(level, pairs).value_or(0.0), tilted_rms_m = height_rms_m(tilted, pairs).value_or(0.0);
  double reach_m = 0.0;
  for (const EarthPair& pair : pairs) reach_m = std::max(reach_m, pair.frame_m.head<2>().norm());
  const double tilt_rad = std::acos(std::min(1.0, tilted.rotation(2, 2)));
  const double free = std::max(1.0, static_cast<double>(pairs.size()) - 3.0);
  const double tilt_sd_rad = tilted_rms_m * std::sqrt(static_cast<double>(pairs.size()) / free) / std::max(1.0, reach_m);
  return level_rms_m > 3.0 * tilted_rms_m && level_rms_m > 0.05 && tilt_rad > 3.0 * tilt_sd_rad;
}

/// How the chosen points are fitted, so that "without one of them" is the same fit.
struct Fitter {
  std::optional<double> fixed_yaw_rad;
  bool tilted = false;
  std::size_t needed() const { return tilted ? 3 : fixed_yaw_rad ? 1 : 2; }
  int parameters() const { return fixed_yaw_rad ? 2 : 3; }
  EarthFit operator()(const Pairs& pairs) const { return tilted ? fit_tilted(pairs) : fit_level(pairs, fixed_yaw_rad); }
};

std::vector<ControlResidual> residuals_of(const std::vector<ControlPoint>& points, const Pairs& pairs, const Indices& used, const Fitter& fitter) {
  const EarthFit fit = fitter(chosen(pairs, used));
  std::vector<ControlResidual> rows;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ControlResidual row{points[i].name, planar_residual_m(fit, pairs[i]), std::nullopt, std::find(used.begin(), used.end(), i) != used.end()};
    Indices others = used;
    std::erase(others, i);
    const Pairs rest = chosen(pairs, others);
    if (others.size() >= fitter.needed() && (!fitter.tilted || can_tilt(rest))) row.leave_one_out_m = planar_residual_m(fitter(rest), pairs[i]);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The tangent plane's fit as a georeference: anchored at the points' middle.
Georeference georeference_of(const EarthFit& fit, const Georeference& plane, const Eigen::Vector3d& anchored_point_m) {
  Georeference out = plane;
  out.origin = geodetic_from_reference(plane, {fit.shift_m.x(), fit.shift_m.y(), 0.0});
  out.origin.height_m = fit.shift_m.z();
  out.anchored_point_m = anchored_point_m;
  const RollPitchYaw angles = roll_pitch_yaw(fit.rotation);
  out.azimuth_deg = std::fmod(degrees(-angles.yaw_rad) + 720.0, 360.0);
  out.roll_deg = degrees(angles.roll_rad);
  out.pitch_deg = degrees(angles.pitch_rad);
  return out;
}

Issues left_out(const std::vector<ControlResidual>& residuals) {
  Issues issues;
  for (const ControlResidual& row : residuals) {
    if (row.used) continue;
    char text[96];
    std::snprintf(text, sizeof text, ": %.2f m from where the other control points put it, left out", row.residual_m);
    issues.push_back({Severity::warning, "", 0, "", row.name + text, "check this point"});
  }
  return issues;
}

std::string method_text(const ControlReport& report, std::size_t used, bool translation_only) {
  return "control points (" + std::to_string(used) + (translation_only ? ", azimuth given" : report.tilted ? ", tilted" : "") + ")";
}

}  // namespace

Result<ControlReport> solve_control_points(const std::vector<ControlPoint>& points, const ControlSettings& settings) {
  if (points.empty()) return Result<ControlReport>::failure(error("no control points", ""));
  Georeference plane;
  plane.kind = GeoreferenceKind::anchor;
  plane.origin = middle(points);
  const Pairs pairs = pairs_of(points, plane);
  if (auto issue = check(pairs, settings.translation_only)) return Result<ControlReport>::failure(*issue);
  Fitter fitter;
  if (settings.translation_only) fitter.fixed_yaw_rad.emplace(-radians(settings.azimuth_deg));
  const Indices used = consensus(pairs, settings, fitter.fixed_yaw_rad);
  if (used.size() < pairs.size() && (used.size() < 3 || 2 * used.size() <= pairs.size()))  // any two points agree with each other
    return Result<ControlReport>::failure(error("only " + std::to_string(used.size()) + " of " + std::to_string(pairs.size()) + " control points agree, so none of them can be trusted",
                                                "are latitude and longitude, or x and y, the wrong way round, or ids mixed up?"));
  const Pairs kept = chosen(pairs, used);
  const EarthFit level = fitter(kept);
  const bool may_tilt = !settings.translation_only && settings.level != LevelChoice::level && can_tilt(kept);
  if (settings.level == LevelChoice::tilted && !may_tilt)
    return Result<ControlReport>::failure(error("a tilted frame needs three control points with heights that do not stand on one line", "give more points, or take the frame as level (--level)"));
  fitter.tilted = may_tilt && (settings.level == LevelChoice::tilted || says_tilted(level, fit_tilted(kept), kept));
  const EarthFit fit = fitter(kept);

  ControlReport out;
  out.tilted = fitter.tilted;
  out.height_rms_m = height_rms_m(fit, kept);
  out.georeference = georeference_of(fit, plane, middle_in_reference(points));
  out.georeference.residuals = residuals_of(points, pairs, used, fitter);
  double sum_sq = 0.0;
  for (const EarthPair& pair : kept) sum_sq += planar_residual_m(fit, pair) * planar_residual_m(fit, pair);
  out.rms_m = std::sqrt(sum_sq / static_cast<double>(kept.size()));
  const EarthFitError sd = error_of(fit, kept, fitter.parameters());
  out.georeference.sd_m = sd.middle_m;
  out.georeference.azimuth_sd_deg = settings.translation_only ? 0.0 : degrees(sd.yaw_rad);
  out.georeference.method = method_text(out, used.size(), settings.translation_only);
  return {out, left_out(out.georeference.residuals)};
}

}  // namespace stemwise
