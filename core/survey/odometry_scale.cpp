#include "core/survey/odometry_scale.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/survey/merge_coincident.hpp"
#include "core/survey/refine_pose.hpp"
#include "core/survey/stand_growth.hpp"

namespace stemwise {
namespace {

constexpr double merge_radius_m = 0.3, start_sigma_m = 0.6, noise_floor_m = 0.05;
constexpr double most_noise_m = 0.4;  // a link whose stems lie no nearer to each other than this is none

struct Link {
  std::size_t first = 0, second = 0;
};

std::vector<Link> links_along(const FrameSet& frames, const OdometryScaleSettings& settings) {
  std::vector<double> way_m{0.0};
  for (std::size_t i = 1; i < frames.frames.size(); ++i)
    way_m.push_back(way_m.back() + (frames.frames[i].pose.survey_from_frame.translation_m - frames.frames[i - 1].pose.survey_from_frame.translation_m).norm());
  std::vector<Link> links;
  double next_m = 0.0;
  for (std::size_t i = 0; i < way_m.size(); ++i) {
    if (way_m[i] < next_m) continue;
    const auto end = static_cast<std::size_t>(std::lower_bound(way_m.begin(), way_m.end(), way_m[i] + settings.link_m) - way_m.begin());
    if (end >= way_m.size()) break;
    links.push_back({i, end});
    next_m = way_m[i] + settings.link_step_m;
  }
  return links;
}

/// The reconstructed stems of a frame, turned as the survey is, around the frame's own place.
IndexedList stems_of(const Frame& frame) {
  std::vector<Stem> stems;
  for (Stem stem : frame.stems) {
    if (!stem.reconstructed) continue;
    const Eigen::Vector3d p = frame.pose.survey_from_frame.rotation * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
    stem.x_m = p.x(), stem.y_m = p.y();
    stems.push_back(std::move(stem));
  }
  return IndexedList(merge_coincident(stems, merge_radius_m));
}

/// True over told length of one link, along it; nothing where its stems do not tell.
std::optional<double> ratio_of(const FrameSet& frames, const Link& link, const OdometryScaleSettings& settings) {
  const IndexedList first = stems_of(frames.frames[link.first]), second = stems_of(frames.frames[link.second]);
  if (first.size() < static_cast<std::size_t>(settings.least_matched) || second.size() < static_cast<std::size_t>(settings.least_matched)) return std::nullopt;
  const Eigen::Vector2d told =
      (frames.frames[link.second].pose.survey_from_frame.translation_m - frames.frames[link.first].pose.survey_from_frame.translation_m).head<2>();
  if (told.norm() < 0.5 * settings.link_m) return std::nullopt;  // it turned back
  const Eigen::Vector2d shift = told + second.nodes.origin_m - first.nodes.origin_m;
  std::vector<std::size_t> all(second.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const PoseFit fit = refine_pose(second, all, first, {PlanarPose{shift.x(), shift.y(), 0.0}, start_sigma_m, {true, 0.0, 1.0}, 0.0}, noise_floor_m);
  if (fit.soft_matched < settings.least_matched || fit.noise_m > most_noise_m) return std::nullopt;
  const Eigen::Vector2d found = fit.b_from_a * Eigen::Vector2d(-second.nodes.origin_m) + first.nodes.origin_m;  // the second frame's own place
  return found.dot(told) / told.squaredNorm();
}

}  // namespace

OdometryScale estimate_odometry_scale(const FrameSet& frames, int threads, const OdometryScaleSettings& settings) {
  OdometryScale result;
  const std::vector<Link> links = links_along(frames, settings);
  std::vector<std::optional<double>> found(links.size());
  parallel_for(links.size(), threads, [&](std::size_t k) { found[k] = ratio_of(frames, links[k], settings); });
  std::vector<double> ratios;
  for (const auto& ratio : found)
    if (ratio) ratios.push_back(*ratio);
  result.links = static_cast<int>(ratios.size());
  if (result.links < settings.least_links) return result;
  const Estimate location = huber_location(ratios);
  result.ci95 = location.ci95;
  const bool beyond = location.ci95[0] > 1.0 || location.ci95[1] < 1.0;
  result.significant = beyond && std::abs(location.value - 1.0) >= settings.least_change;
  if (result.significant) result.scale = location.value;
  return result;
}

FrameSet with_scaled_steps(FrameSet frames, double scale) {
  if (frames.frames.empty()) return frames;
  const Eigen::Vector3d start = frames.frames.front().pose.survey_from_frame.translation_m;
  for (Frame& frame : frames.frames) {
    Eigen::Vector3d& place = frame.pose.survey_from_frame.translation_m;
    place = start + scale * (place - start);
  }
  return frames;
}

}  // namespace stemwise
