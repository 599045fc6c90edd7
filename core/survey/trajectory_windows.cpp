#include "core/survey/trajectory_windows.hpp"

#include <algorithm>
#include <numeric>

#include "core/survey/align_lists.hpp"
#include "core/survey/build_global_inventory.hpp"
#include "core/survey/merge_coincident.hpp"
#include "core/survey/refine_pose.hpp"

namespace stemwise {
namespace {

constexpr std::size_t least_nodes = 12;
constexpr std::size_t most_searches = 6;
constexpr double start_sigma_m = 1.2;
constexpr int least_matched = 8;

IndexedList list_of(const FrameSet& frames, std::size_t first, std::size_t last, const RegisterSettings& settings) {
  FrameSet part;
  part.frames.assign(frames.frames.begin() + static_cast<std::ptrdiff_t>(first), frames.frames.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  return IndexedList(merge_coincident(build_global_inventory(part).stems, settings.lists.merge_radius_m));
}

PlanarPose in_nodes(const PlanarPose& list_from_survey, const IndexedList& window, const IndexedList& list) {
  return PlanarPose{-list.nodes.origin_m.x(), -list.nodes.origin_m.y(), 0.0} * list_from_survey * PlanarPose{window.nodes.origin_m.x(), window.nodes.origin_m.y(), 0.0};
}
PlanarPose from_nodes(const PlanarPose& pose, const IndexedList& window, const IndexedList& list) {
  return PlanarPose{list.nodes.origin_m.x(), list.nodes.origin_m.y(), 0.0} * pose * PlanarPose{-window.nodes.origin_m.x(), -window.nodes.origin_m.y(), 0.0};
}

/// From a guess that is right to about a metre; nothing when the stems do not bear it out.
std::optional<PlanarPose> follow(const IndexedList& window, const IndexedList& list, const PlanarPose& guess, const DbhModel& dbh, const RegisterSettings& settings) {
  if (window.size() < least_nodes) return std::nullopt;
  std::vector<std::size_t> all(window.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  PoseFit fit = refine_pose(window, all, list, {in_nodes(guess, window, list), start_sigma_m, dbh, 0.0}, settings.lists.noise_floor_m);
  fit.dbh = refit_dbh(window, all, list, fit);
  fit = refine_pose(window, all, list, fit, settings.lists.noise_floor_m);
  const PoseScore score = score_pose(window, list, fit, nullptr);
  if (score.matched < least_matched || score.log_likelihood_ratio < settings.list_accept_log_ratio) return std::nullopt;
  return from_nodes(fit.b_from_a, window, list);
}

struct FirstWindow {
  std::size_t window = 0;
  PlanarPose pose;
  DbhModel dbh;
};

/// The fullest windows first, until one is accepted.
std::optional<FirstWindow> find_first(const std::vector<TrajectoryWindow>& windows, const IndexedList& list, std::optional<double> years, const RegisterSettings& settings,
                                      int threads, const Progress& progress) {
  std::vector<std::size_t> order(windows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) { return windows[p].list.size() > windows[q].list.size(); });
  for (std::size_t k = 0; k < std::min(most_searches, order.size()); ++k) {
    ListHints hints;
    hints.years = years;
    const ListAlignment found = align_lists(windows[order[k]].list, list, hints, settings.lists, threads, progress);
    if (found.status == AlignmentStatus::aligned) return FirstWindow{order[k], found.b_from_a, found.dbh};
  }
  return std::nullopt;
}

}  // namespace

std::vector<TrajectoryWindow> windows_along(const FrameSet& frames, const RegisterSettings& settings) {
  std::vector<TrajectoryWindow> windows;
  const std::size_t count = frames.frames.size();
  if (count == 0) return windows;
  std::vector<double> way_m(count, 0.0);
  const auto place = [&](std::size_t i) { return frames.frames[i].pose.survey_from_frame.translation_m; };
  for (std::size_t i = 1; i < count; ++i) way_m[i] = way_m[i - 1] + (place(i) - place(i - 1)).norm();
  const auto at = [&](double way) { return std::min(count - 1, static_cast<std::size_t>(std::lower_bound(way_m.begin(), way_m.end(), way) - way_m.begin())); };
  for (double start_m = 0.0; start_m == 0.0 || start_m + 0.5 * settings.window_m < way_m.back(); start_m += settings.window_step_m) {
    const std::size_t first = at(start_m), last = at(start_m + settings.window_m);
    windows.push_back({first, last, at(start_m + 0.5 * settings.window_m), list_of(frames, first, last, settings)});
  }
  return windows;
}

std::vector<std::optional<PlanarPose>> place_windows(const std::vector<TrajectoryWindow>& windows, const IndexedList& list, std::optional<double> years,
                                                     const std::vector<PlanarPose>& guess, const RegisterSettings& settings, int threads, const Progress& progress) {
  std::vector<std::optional<PlanarPose>> poses(windows.size());
  if (!guess.empty()) {
    for (std::size_t w = 0; w < windows.size(); ++w) poses[w] = follow(windows[w].list, list, guess[w], {true, 0.0, 1.0}, settings);
    return poses;
  }
  const auto first = find_first(windows, list, years, settings, threads, progress);
  if (!first) return poses;
  poses[first->window] = first->pose;
  PlanarPose last = first->pose;
  for (std::size_t w = first->window + 1; w < windows.size(); ++w)
    if ((poses[w] = follow(windows[w].list, list, last, first->dbh, settings))) last = *poses[w];
  last = first->pose;
  for (std::size_t w = first->window; w-- > 0;)
    if ((poses[w] = follow(windows[w].list, list, last, first->dbh, settings))) last = *poses[w];
  return poses;
}

}  // namespace stemwise
