#include "core/survey/query_scenes.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace stemwise {
namespace {

constexpr double tape_cells = 3.0;  // a second look at small lists: maps made by compass and tape are off by more than a metre

Scene scene_around(const IndexedList& list, const Eigen::Vector2d& centre_m, std::vector<std::size_t> nodes) {
  Scene scene{centre_m, 0.0, std::move(nodes), false, 0.4};
  for (const std::size_t i : scene.nodes) scene.radius_m = std::max(scene.radius_m, (list.nodes.at_m[i] - centre_m).norm());
  return scene;
}

Scene whole(const IndexedList& list, double cell_m) {
  std::vector<std::size_t> all(list.size());
  std::iota(all.begin(), all.end(), 0);
  Scene scene = scene_around(list, 0.5 * (list.low_m + list.high_m), std::move(all));
  scene.whole_list = true;
  scene.cell_m = cell_m;
  return scene;
}

std::vector<Scene> spread_scenes(const IndexedList& list, std::size_t count, std::size_t stems, double cell_m) {
  const auto& at = list.nodes.at_m;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& p : at) middle += p / static_cast<double>(at.size());
  std::vector<Scene> scenes;
  std::vector<double> nearest_sq(at.size(), std::numeric_limits<double>::infinity());
  std::size_t next = list.index.nearest(middle, 1).front();
  while (scenes.size() < count) {
    auto nodes = list.index.nearest(at[next], stems);
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // at the border the nodes' own middle makes the smaller circle
    for (const std::size_t i : nodes) centre += at[i] / static_cast<double>(nodes.size());
    for (std::size_t i = 0; i < at.size(); ++i) nearest_sq[i] = std::min(nearest_sq[i], (at[i] - at[next]).squaredNorm());
    scenes.push_back(scene_around(list, centre, std::move(nodes)));
    scenes.back().cell_m = cell_m;
    next = static_cast<std::size_t>(std::max_element(nearest_sq.begin(), nearest_sq.end()) - nearest_sq.begin());
    if (nearest_sq[next] == 0.0) break;
  }
  return scenes;
}

}  // namespace

std::vector<Scene> query_scenes(const IndexedList& list, const ListSettings& settings) {
  if (list.size() == 0) return {};
  const auto stems = static_cast<std::size_t>(settings.scene_stems);
  if (list.size() > static_cast<std::size_t>(settings.whole_list_stems))
    return spread_scenes(list, static_cast<std::size_t>(settings.scenes), stems, settings.coarse_cell_m);
  if (list.size() <= stems + stems / 4) return {whole(list, settings.cell_m), whole(list, tape_cells * settings.cell_m)};
  auto scenes = spread_scenes(list, static_cast<std::size_t>(settings.first_scenes), stems, settings.middle_cell_m);
  scenes.push_back(whole(list, settings.middle_cell_m));
  return scenes;
}

}  // namespace stemwise
