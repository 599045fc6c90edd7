#include "core/survey/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/planar_index.hpp"
#include "core/geometry/raster_mask.hpp"

namespace stemwise {
namespace {

double percentile(std::vector<double>& values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Ranges of reconstructed stems; of all stems where none is.
double range_seen_m(const FrameSet& frames, const CoverageSettings& settings) {
  std::vector<double> reconstructed, all;
  for (const Frame& frame : frames.frames)
    for (const Stem& stem : frame.stems) {
      all.push_back(std::hypot(stem.x_m, stem.y_m));
      if (stem.reconstructed) reconstructed.push_back(all.back());
    }
  std::vector<double>& ranges = reconstructed.empty() ? all : reconstructed;
  return ranges.empty() ? settings.least_range_m : std::max(settings.least_range_m, percentile(ranges, settings.seen_share));
}

/// Grows the points until nearly all hang together, then shrinks back to `margin_m` around them.
RasterMask footprint(std::span<const Eigen::Vector2d> points, double close_m, double margin_m, double cell_m) {
  constexpr double nearly_all = 0.98;
  for (double radius_m = close_m;; radius_m *= 1.5) {
    RasterMask mask(points, radius_m + margin_m, cell_m);
    for (const auto& p : points) mask.set(p);
    RasterMask grown = mask.dilated(radius_m).largest_part();
    const auto held = std::count_if(points.begin(), points.end(), [&](const Eigen::Vector2d& p) { return grown.at(p); });
    if (static_cast<double>(held) < nearly_all * static_cast<double>(points.size())) continue;
    RasterMask shrunk = grown.eroded(std::max(0.0, radius_m - margin_m));
    if (shrunk.count() == 0 || shrunk.part_count() > 1) return grown;
    return shrunk;
  }
}

/// Median distance to the nearest other stem at another place, made robust for clumps: to the third nearest, halved.
double typical_spacing_m(const std::vector<Eigen::Vector2d>& points) {
  const PlanarIndex index(points, PlanarIndex::usual_cell_m(points));
  std::vector<double> spacings;
  const std::size_t step = std::max<std::size_t>(1, points.size() / 2000);
  for (std::size_t i = 0; i < points.size(); i += step) spacings.push_back(index.distance_to_kth_m(points[i], std::min<std::size_t>(4, points.size())));
  return std::max(0.5, 0.6 * percentile(spacings, 0.5));  // 4th with itself: the 3rd nearest lies about 1.7 spacings away
}

std::vector<Eigen::Vector2d> places_of(std::span<const Stem> stems) {
  std::vector<Eigen::Vector2d> points;
  for (const Stem& stem : stems)
    if (std::isfinite(stem.x_m) && std::isfinite(stem.y_m)) points.emplace_back(stem.x_m, stem.y_m);
  return points;
}

}  // namespace

Fields CoverageSettings::fields() {
  return {{"coverage.seen_share", "", "A frame covers the radius that holds this share of its reconstructed stems.", &seen_share},
          {"coverage.least_range_m", "m", "A frame covers at least this radius.", &least_range_m},
          {"coverage.frame_cell_m", "m", "Raster of the union of the frames' discs.", &frame_cell_m},
          {"coverage.smallest_hole_sq_m", "m2", "Holes smaller than this count as looked at.", &smallest_hole_sq_m},
          {"coverage.close_spacings", "", "Stems nearer than twice this many spacings belong together.", &close_spacings}};
}

Coverage coverage_from_frames(const FrameSet& frames, const CoverageSettings& settings) {
  Coverage coverage{{}, CoverageSource::frames};
  std::vector<Eigen::Vector2d> poses;
  for (const Frame& frame : frames.frames) poses.push_back(frame.pose.survey_from_frame.translation_m.head<2>());
  if (poses.empty()) return coverage;
  const double range_m = range_seen_m(frames, settings);
  const double cell_m = std::min(settings.frame_cell_m, range_m / 8.0);
  coverage.in_inventory = footprint(poses, range_m, range_m, cell_m).without_holes(settings.smallest_hole_sq_m).outline();
  return coverage;
}

Coverage coverage_from_stems(std::span<const Stem> stems, const CoverageSettings& settings) {
  Coverage coverage{{}, CoverageSource::stems};
  const std::vector<Eigen::Vector2d> points = places_of(stems);
  if (points.empty()) return coverage;
  if (points.size() < 3) {
    constexpr double around_m = 5.0;
    coverage.in_inventory = footprint(points, around_m, around_m, 0.5).outline();
    return coverage;
  }
  const double spacing_m = typical_spacing_m(points);
  const double close_m = settings.close_spacings * spacing_m, margin_m = 0.5 * spacing_m;
  const RasterMask mask = footprint(points, close_m, margin_m, margin_m / 3.0);
  coverage.in_inventory = mask.without_holes(settings.smallest_hole_sq_m).outline();
  return coverage;
}

Coverage estimate_coverage(const Inventory& inventory) {
  if (inventory.frames && !inventory.frames->frames.empty()) return coverage_from_frames(*inventory.frames);
  return coverage_from_stems(inventory.stems);
}

}  // namespace stemwise
