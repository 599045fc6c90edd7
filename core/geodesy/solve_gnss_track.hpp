#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/geodesy/georeference.hpp"

namespace stemwise {

/// One position of a GNSS receiver that travelled with the scanner.
struct GnssFix {
  double timestamp_s = 0.0;
  Geodetic on_earth;               ///< height above the ellipsoid
  bool has_height = false;
  std::optional<double> sd_m;      ///< planar, one axis, as the receiver claims
};

/// Where the scanner was.
struct TrackPoint {
  double timestamp_s = 0.0;
  Eigen::Vector3d in_reference_m = Eigen::Vector3d::Zero();
};

struct GnssSettings {
  double most_gap_s = 5.0;         ///< a fix between two poses farther apart in time than this is left out
  double default_sd_m = 1.5;       ///< of fixes without their own
  double outlier_sigmas = 3.5;     ///< robust; farther from the fit: multipath, left out
  int stretches = 10;              ///< pieces of the track for the leave-one-out residuals
  double time_offset_s = 0.0;      ///< added to the fixes' time stamps
};

struct GnssReport {
  Georeference georeference;       ///< residuals: one per stretch
  int fixes = 0;                   ///< joined to the trajectory by time
  int used = 0;
  double rms_m = 0.0;              ///< planar, of the used fixes
  double independent = 0.0;        ///< how many independent fixes the used ones are worth: errors last for minutes
};

/// The level rigid pose of the reference's frame from a GNSS track (poses and fixes in any order, joined by time): a
/// consensus of pairs of fixes, then reweighted least squares with the Geman-McClure weight (Geman and McClure 1987), then
/// least squares over what lies within the outlier bound. Multipath is left out as long as less than half of the fixes have
/// it. An error issue when nothing joins, or the track is too short to show a direction.
Result<GnssReport> solve_gnss_track(std::vector<TrackPoint> track, std::vector<GnssFix> fixes, const GnssSettings& settings = {});

}  // namespace stemwise
