#include "core/survey/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/planar_index.hpp"
#include "core/geometry/raster_mask.hpp"
#include "core/survey/shared_border.hpp"

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

bool holds_nearly_all(const RasterMask& mask, std::span<const Eigen::Vector2d> points) {
  constexpr double nearly_all = 0.98;
  const auto held = std::count_if(points.begin(), points.end(), [&](const Eigen::Vector2d& p) { return mask.at(p); });
  return static_cast<double>(held) >= nearly_all * static_cast<double>(points.size());
}

/// Shrinks by `most_m`, or by less where that would take away points or fall into parts: never by nothing at one weak spot.
RasterMask shrunk_around(const RasterMask& grown, std::span<const Eigen::Vector2d> points, double most_m) {
  RasterMask shrunk = grown.eroded(most_m).largest_part();
  if (shrunk.count() > 0 && holds_nearly_all(shrunk, points)) return shrunk;
  RasterMask best = grown;
  double low_m = 0.0, high_m = most_m;
  for (int halving = 0; halving < 5; ++halving) {
    const double by_m = 0.5 * (low_m + high_m);
    shrunk = grown.eroded(by_m).largest_part();
    const bool holds = shrunk.count() > 0 && holds_nearly_all(shrunk, points);
    (holds ? low_m : high_m) = by_m;
    if (holds) best = std::move(shrunk);
  }
  return best;
}

/// Grows the points until nearly all hang together, then shrinks back to `margin_m` around them.
RasterMask footprint(std::span<const Eigen::Vector2d> points, double close_m, double margin_m, double cell_m) {
  for (double radius_m = close_m;; radius_m *= 1.5) {
    RasterMask mask(points, radius_m + margin_m, cell_m);
    for (const auto& p : points) mask.set(p);
    const RasterMask grown = mask.dilated(radius_m).largest_part();
    if (holds_nearly_all(grown, points)) return shrunk_around(grown, points, std::max(0.0, radius_m - margin_m));
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

Coverage around(const std::vector<Eigen::Vector2d>& points, const CoverageSettings& settings) {
  Coverage coverage{{}, CoverageSource::stems};
  if (points.empty()) return coverage;
  if (points.size() < 3) {
    constexpr double around_m = 5.0;
    coverage.in_inventory = footprint(points, around_m, around_m, 0.5).outline();
    return coverage;
  }
  const double spacing_m = typical_spacing_m(points);
  const double margin_m = settings.margin_spacings * spacing_m;
  const RasterMask mask = footprint(points, settings.close_spacings * spacing_m, margin_m, spacing_m / 6.0);
  coverage.in_inventory = mask.without_holes(settings.smallest_hole_sq_m).outline();
  return coverage;
}

/// The coverage of a bare list once more, with the trees that others saw at its border.
Coverage with_border(Coverage coverage, const PlacedInventory& survey, std::span<const PlacedInventory> others) {
  std::vector<Eigen::Vector2d> points = places_of(survey.inventory->stems);
  if (coverage.source != CoverageSource::stems || points.size() < 3) return coverage;
  const CoverageSettings settings;
  const double reach_m = std::max(1.0, settings.margin_spacings * typical_spacing_m(points));
  const auto border = shared_border(survey, coverage.in_inventory, others, reach_m);
  if (border.empty()) return coverage;
  points.insert(points.end(), border.begin(), border.end());
  return around(points, settings);
}

}  // namespace

Fields CoverageSettings::fields() {
  return {{"coverage.seen_share", "", "A frame covers the radius that holds this share of its reconstructed stems.", &seen_share},
          {"coverage.least_range_m", "m", "A frame covers at least this radius.", &least_range_m},
          {"coverage.frame_cell_m", "m", "Raster of the union of the frames' discs.", &frame_cell_m},
          {"coverage.smallest_hole_sq_m", "m2", "Holes smaller than this count as looked at.", &smallest_hole_sq_m},
          {"coverage.margin_spacings", "", "A list covers so many spacings around its outermost stems.", &margin_spacings},
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
  return around(places_of(stems), settings);
}

Coverage estimate_coverage(const Inventory& inventory) {
  if (inventory.frames && !inventory.frames->frames.empty()) return coverage_from_frames(*inventory.frames);
  return coverage_from_stems(inventory.stems);
}

std::vector<Coverage> estimate_coverages(std::span<const Inventory* const> inventories, const SurveyAlignment& alignment) {
  std::vector<PlacedInventory> placed;
  for (const Inventory* inventory : inventories)
    for (const InventoryAlignment& a : alignment.inventories)
      if (a.inventory == inventory->id && (a.status == AlignmentStatus::aligned || a.status == AlignmentStatus::reference)) placed.push_back({inventory, a.reference_from_inventory});
  std::vector<Coverage> coverages;
  for (const Inventory* inventory : inventories) {
    coverages.push_back(estimate_coverage(*inventory));
    for (const PlacedInventory& survey : placed)
      if (survey.inventory == inventory) coverages.back() = with_border(std::move(coverages.back()), survey, placed);
  }
  return coverages;
}

}  // namespace stemwise
