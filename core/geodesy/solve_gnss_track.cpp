#include "core/geodesy/solve_gnss_track.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/base/quantile.hpp"
#include "core/geodesy/earth_fit.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {
namespace {

using Pairs = std::vector<EarthPair>;

/// Where the scanner was at a time, between two poses; nothing outside the trajectory or in a gap of it.
std::optional<Eigen::Vector3d> position_at(const std::vector<TrackPoint>& track, double time_s, double most_gap_s) {
  const auto after = std::lower_bound(track.begin(), track.end(), time_s, [](const TrackPoint& p, double t) { return p.timestamp_s < t; });
  if (after == track.end()) return std::nullopt;
  if (after->timestamp_s == time_s) return after->in_reference_m;
  if (after == track.begin() || after->timestamp_s - std::prev(after)->timestamp_s > most_gap_s) return std::nullopt;
  const TrackPoint& before = *std::prev(after);
  const double part = (time_s - before.timestamp_s) / (after->timestamp_s - before.timestamp_s);
  return before.in_reference_m + part * (after->in_reference_m - before.in_reference_m);
}

/// The fixes that lie on the trajectory, in order of time.
struct Joined {
  Pairs pairs;
  std::vector<double> time_s;
  Georeference plane;
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();  ///< of the track, in the reference's frame, z 0
};

Joined join(const std::vector<TrackPoint>& track, const std::vector<GnssFix>& fixes, const GnssSettings& settings) {
  Joined out;
  std::vector<const GnssFix*> kept;
  std::vector<Eigen::Vector3d> places;
  for (const GnssFix& fix : fixes) {
    const auto place = position_at(track, fix.timestamp_s + settings.time_offset_s, settings.most_gap_s);
    if (!place) continue;
    kept.push_back(&fix);
    places.push_back(*place);
  }
  if (kept.empty()) return out;
  std::vector<double> latitudes, longitudes;
  for (const GnssFix* fix : kept) latitudes.push_back(fix->on_earth.latitude_deg), longitudes.push_back(fix->on_earth.longitude_deg);
  out.plane.kind = GeoreferenceKind::anchor;
  out.plane.origin = {median(latitudes), median(longitudes), 0.0};
  for (const Eigen::Vector3d& place : places) out.middle_m += place / static_cast<double>(places.size());
  out.middle_m.z() = 0.0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const double sd_m = std::max(0.01, kept[i]->sd_m.value_or(settings.default_sd_m));
    out.pairs.push_back({places[i] - out.middle_m, reference_from_geodetic(out.plane, kept[i]->on_earth), kept[i]->has_height, 1.0 / (sd_m * sd_m)});
    out.time_s.push_back(kept[i]->timestamp_s);
  }
  return out;
}

std::vector<std::size_t> evenly(std::size_t count, std::size_t most) {
  std::vector<std::size_t> out;
  const std::size_t n = std::min(count, most);
  for (std::size_t i = 0; i < n; ++i) out.push_back(i * count / n);
  return out;
}

double reach_m(const Pairs& pairs) {
  double most = 0.0;
  for (const EarthPair& a : pairs) most = std::max(most, (a.frame_m - pairs.front().frame_m).head<2>().norm());
  return most;
}

/// The pose of the pair of fixes that the whole track speaks best for: truncated squares (Torr and Zisserman 2000, MSAC).
EarthFit consensus(const Pairs& pairs) {
  constexpr double bound_sigmas_sq = 9.0;
  const double least_m = 0.3 * reach_m(pairs);
  const std::vector<std::size_t> proposers = evenly(pairs.size(), 64), voters = evenly(pairs.size(), 500);
  EarthFit best;
  double least_cost = std::numeric_limits<double>::infinity();
  for (const std::size_t i : proposers)
    for (const std::size_t j : proposers) {
      if (j <= i || (pairs[i].frame_m - pairs[j].frame_m).head<2>().norm() < least_m) continue;
      const EarthFit fit = fit_level({pairs[i], pairs[j]});
      double cost = 0.0;
      for (const std::size_t k : voters) {
        const double off_m = planar_residual_m(fit, pairs[k]);
        cost += std::min(bound_sigmas_sq, off_m * off_m * pairs[k].weight);
      }
      if (cost < least_cost) best = fit, least_cost = cost;
    }
  return best;
}

/// Residuals in claimed standard deviations.
std::vector<double> sigmas_of(const EarthFit& fit, const Pairs& pairs) {
  std::vector<double> out;
  for (const EarthPair& pair : pairs) out.push_back(planar_residual_m(fit, pair) * std::sqrt(pair.weight));
  return out;
}

/// Of one axis, in claimed standard deviations: the median of a planar (Rayleigh) residual is 1.177 of them.
double robust_scale(const EarthFit& fit, const Pairs& pairs) { return std::max(0.05, median(sigmas_of(fit, pairs)) / 1.1774); }

EarthFit reweighted(const Pairs& pairs, EarthFit fit) {
  for (int round = 0; round < 30; ++round) {
    const double scale = 3.0 * robust_scale(fit, pairs);
    Pairs weighted = pairs;
    const std::vector<double> sigmas = sigmas_of(fit, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double u = sigmas[i] / scale;
      weighted[i].weight *= 1.0 / ((1.0 + u * u) * (1.0 + u * u));
    }
    const EarthFit next = fit_level(weighted);
    const bool settled = (next.shift_m - fit.shift_m).norm() < 1e-6 && std::abs(wrap_angle(yaw_rad(next) - yaw_rad(fit))) < 1e-9;
    fit = next;
    if (settled) break;
  }
  return fit;
}

Pairs chosen(const Pairs& pairs, const std::vector<bool>& use) {
  Pairs out;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (use[i]) out.push_back(pairs[i]);
  return out;
}

double rms_m(const EarthFit& fit, const Pairs& pairs) {
  double sum_sq = 0.0;
  for (const EarthPair& pair : pairs) sum_sq += planar_residual_m(fit, pair) * planar_residual_m(fit, pair);
  return std::sqrt(sum_sq / static_cast<double>(std::max<std::size_t>(1, pairs.size())));
}

/// Share of the fixes that are worth an independent one: 1 over the integrated autocorrelation time of the residuals, summed
/// up to five times itself (Sokal 1997, section 3), and corrected for the mean that the fit has taken out of them.
double independent_share(const EarthFit& fit, const Pairs& pairs) {
  std::vector<Eigen::Vector2d> off;
  double square = 0.0;
  for (const EarthPair& pair : pairs) {
    off.push_back((fit * pair.frame_m - pair.enu_m).head<2>());
    square += off.back().squaredNorm();
  }
  if (square <= 0.0) return 1.0;
  const auto n = static_cast<double>(off.size());
  double time = 1.0;
  for (std::size_t lag = 1; lag < off.size() / 2 && static_cast<double>(lag) < 5.0 * time; ++lag) {
    double product = 0.0;
    for (std::size_t i = lag; i < off.size(); ++i) product += off[i].dot(off[i - lag]);
    const double correlation = product / square * n / (n - static_cast<double>(lag));
    time = std::max(1.0, time + 2.0 * (correlation + (1.0 - correlation) * time / n));
  }
  return 1.0 / std::min(time, n / 2.5);
}

/// Every piece of the track against the fit of all, and against that of the other pieces.
std::vector<ControlResidual> stretches_of(const Joined& joined, const std::vector<bool>& used, const EarthFit& fit, int wanted) {
  std::vector<ControlResidual> rows;
  const std::size_t n = joined.pairs.size(), pieces = std::min<std::size_t>(n, static_cast<std::size_t>(std::max(1, wanted)));
  for (std::size_t p = 0; p < pieces; ++p) {
    const std::size_t from = p * n / pieces, to = (p + 1) * n / pieces;
    std::vector<bool> others = used, own(n, false);
    std::size_t inside = 0;
    for (std::size_t i = from; i < to; ++i) others[i] = false, own[i] = true, inside += used[i] ? 1 : 0;
    const Pairs rest = chosen(joined.pairs, others), piece = chosen(joined.pairs, own);
    char name[96];
    std::snprintf(name, sizeof name, "track %.0f to %.0f s (%zu of %zu fixes)", joined.time_s[from] - joined.time_s.front(), joined.time_s[to - 1] - joined.time_s.front(),
                  inside, to - from);
    ControlResidual row{name, rms_m(fit, piece), std::nullopt, 2 * inside >= to - from};
    if (rest.size() >= 2 && reach_m(rest) > 1.0) row.leave_one_out_m = rms_m(fit_level(rest), piece);
    rows.push_back(std::move(row));
  }
  return rows;
}

Result<GnssReport> refused(std::string text, std::string help) { return Result<GnssReport>::failure(Issue{Severity::error, "", 0, "", std::move(text), std::move(help)}); }

Georeference georeference_of(const EarthFit& fit, const Joined& joined) {
  Georeference out = joined.plane;
  out.origin = geodetic_from_reference(joined.plane, {fit.shift_m.x(), fit.shift_m.y(), 0.0});
  out.origin.height_m = fit.shift_m.z();
  out.anchored_point_m = joined.middle_m;
  out.azimuth_deg = std::fmod(degrees(-yaw_rad(fit)) + 720.0, 360.0);
  return out;
}

}  // namespace

Result<GnssReport> solve_gnss_track(std::vector<TrackPoint> track, std::vector<GnssFix> fixes, const GnssSettings& settings) {
  const auto by_time = [](const auto& a, const auto& b) { return a.timestamp_s < b.timestamp_s; };
  std::stable_sort(track.begin(), track.end(), by_time);
  std::stable_sort(fixes.begin(), fixes.end(), by_time);
  const Joined joined = join(track, fixes, settings);
  if (joined.pairs.size() < 3) {
    char text[224];
    std::snprintf(text, sizeof text, "%zu of %zu fixes lie on the trajectory by time (it runs from %.3f to %.3f s, the track from %.3f to %.3f s), at least 3 are needed", joined.pairs.size(),
                  fixes.size(), track.empty() ? 0.0 : track.front().timestamp_s, track.empty() ? 0.0 : track.back().timestamp_s, fixes.empty() ? 0.0 : fixes.front().timestamp_s,
                  fixes.empty() ? 0.0 : fixes.back().timestamp_s);
    return refused(text, "do both clocks count from the same instant? --time-offset-s shifts the track's");
  }
  if (reach_m(joined.pairs) < 5.0) return refused("the trajectory moves less than 5 m while there are fixes, too little to show a direction", "use --anchor, or control points");

  const EarthFit robust = reweighted(joined.pairs, consensus(joined.pairs));
  const double bound = settings.outlier_sigmas * robust_scale(robust, joined.pairs);
  std::vector<bool> used;
  for (const double sigma : sigmas_of(robust, joined.pairs)) used.push_back(sigma <= bound);
  const Pairs kept = chosen(joined.pairs, used);
  const EarthFit fit = fit_level(kept);

  GnssReport out;
  out.fixes = static_cast<int>(joined.pairs.size());
  out.used = static_cast<int>(kept.size());
  out.rms_m = rms_m(fit, kept);
  const double share = independent_share(fit, kept);
  out.independent = share * static_cast<double>(kept.size());
  out.georeference = georeference_of(fit, joined);
  out.georeference.residuals = stretches_of(joined, used, fit, settings.stretches);
  const EarthFitError sd = error_of(fit, kept, 3, share);
  out.georeference.sd_m = sd.middle_m;
  out.georeference.azimuth_sd_deg = degrees(sd.yaw_rad);
  out.georeference.method = "GNSS track (" + std::to_string(out.used) + " of " + std::to_string(out.fixes) + " fixes)";
  Result<GnssReport> result(out);
  for (const ControlResidual& row : out.georeference.residuals)
    if (!row.used) result.issues.push_back({Severity::warning, "", 0, "", row.name + ": most of its fixes contradict the rest of the track and were left out", "multipath under the canopy?"});
  return result;
}

}  // namespace stemwise
