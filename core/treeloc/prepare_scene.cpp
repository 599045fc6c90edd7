#include "core/treeloc/prepare_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"

namespace stemwise::treeloc {
namespace {

/// A stem that may enter a scene, with its coordinates in the scene's frame.
struct Offer {
  const Stem* stem = nullptr;
  Eigen::Vector3d position_m;
  Eigen::Vector3d axis;
  bool own = true;
};

Offer offer_of(const Stem& stem) {
  return {&stem, {stem.x_m, stem.y_m, stem.z_m.value_or(0.0)}, stem.axis.value_or(Eigen::Vector3d::Zero()), true};
}

Offer moved_offer(const Stem& stem, const RigidTransform& scene_from_other) {
  Offer offer = offer_of(stem);
  offer.position_m = scene_from_other * offer.position_m;
  offer.axis = scene_from_other.rotation * offer.axis;
  offer.own = false;
  return offer;
}

bool inside(const Eigen::Vector3d& p, double radius_m) { return std::abs(p.x()) <= radius_m && std::abs(p.y()) <= radius_m; }

bool near_one(const std::vector<Offer>& kept, const Eigen::Vector3d& p, double radius_m) {
  return std::any_of(kept.begin(), kept.end(),
                     [&](const Offer& o) { return (o.position_m - p).head<2>().squaredNorm() < radius_m * radius_m; });
}

/// Preceding frames whose pose lies within the search radius, nearest in time first.
std::vector<std::size_t> preceding(const FrameSet& set, std::size_t index, const PrepareSettings& settings) {
  std::vector<std::size_t> found;
  const Eigen::Vector3d here = set.frames[index].pose.survey_from_frame.translation_m;
  for (std::size_t back = 1; back <= static_cast<std::size_t>(std::max(0, settings.preceding_frames)) && back <= index; ++back) {
    const Eigen::Vector3d there = set.frames[index - back].pose.survey_from_frame.translation_m;
    if ((there - here).norm() <= settings.search_radius_m) found.push_back(index - back);
  }
  return found;
}

void add_from_preceding(const FrameSet& set, std::size_t index, const PrepareSettings& settings, bool reconstructed,
                        std::size_t enough, std::vector<Offer>& kept) {
  const RigidTransform frame_from_survey = set.frames[index].pose.survey_from_frame.inverse();
  for (const std::size_t other : preceding(set, index, settings)) {
    const RigidTransform frame_from_other = frame_from_survey * set.frames[other].pose.survey_from_frame;
    for (const Stem& stem : set.frames[other].stems) {
      if (kept.size() >= enough) return;
      if (stem.reconstructed != reconstructed || !stem.dbh_for_matching_m()) continue;
      const Offer offer = moved_offer(stem, frame_from_other);
      if (inside(offer.position_m, settings.local_radius_m) && !near_one(kept, offer.position_m, settings.dedup_radius_m))
        kept.push_back(offer);
    }
  }
}

/// Best observed first: more than two clusters, then two, then the rest, by score inside each.
bool better_observed(const Offer& a, const Offer& b) {
  const auto group = [](const Offer& o) { return std::min(o.stem->number_clusters, 3); };
  if (group(a) != group(b)) return group(a) > group(b);
  return a.stem->score > b.stem->score;
}

std::vector<Offer> own_offers(std::span<const Stem> stems, bool reconstructed, const PrepareSettings& settings) {
  std::vector<Offer> offers;
  for (const Stem& stem : stems) {
    if (stem.reconstructed != reconstructed || !stem.dbh_for_matching_m()) continue;
    const Offer offer = offer_of(stem);
    if (inside(offer.position_m, settings.local_radius_m)) offers.push_back(offer);
  }
  return offers;
}

std::vector<Offer> choose_trees(const FrameSet& set, std::size_t index, const PrepareSettings& settings) {
  const auto& stems = set.frames[index].stems;
  auto kept = own_offers(stems, true, settings);
  if (static_cast<int>(kept.size()) < settings.min_reconstructed) {
    add_from_preceding(set, index, settings, true, std::numeric_limits<std::size_t>::max(), kept);
  }
  const auto target = static_cast<std::size_t>(std::max(0, settings.target_tree_count));
  if (kept.size() < target) {
    auto fill = own_offers(stems, false, settings);
    std::stable_sort(fill.begin(), fill.end(), better_observed);
    fill.resize(std::min(fill.size(), target - kept.size()));
    kept.insert(kept.end(), fill.begin(), fill.end());
  }
  if (kept.size() < target) add_from_preceding(set, index, settings, false, target, kept);
  return kept;
}

SceneTree tree_from(const Offer& offer, const Eigen::Matrix3d& aligned_from_scene) {
  SceneTree tree;
  tree.position_m = aligned_from_scene * offer.position_m;
  tree.axis = aligned_from_scene * offer.axis;
  tree.dbh_m = *offer.stem->dbh_for_matching_m();
  tree.has_height = offer.stem->z_m.has_value();
  tree.reconstructed = offer.stem->reconstructed;
  tree.own = offer.own;
  tree.clusters = offer.stem->number_clusters;
  return tree;
}

/// The nearest ones where there are too many, in order of x.
void order_trees(std::vector<SceneTree>& trees) {
  const auto less = [](const auto& a, const auto& b) { return a < b; };
  const auto range_sq = [](const SceneTree& t) { return t.position_m.head<2>().squaredNorm(); };
  if (trees.size() > Scene::most_trees) {
    std::stable_sort(trees.begin(), trees.end(),
                     [&](const SceneTree& a, const SceneTree& b) { return less(range_sq(a), range_sq(b)); });
    trees.resize(Scene::most_trees);
  }
  std::stable_sort(trees.begin(), trees.end(),
                   [&](const SceneTree& a, const SceneTree& b) { return less(a.position_m.x(), b.position_m.x()); });
}

/// Base height under the origin: the median over the trees within 10 m (at least 3).
void observe_ground(Scene& scene) {
  std::vector<double> heights;
  for (const SceneTree& tree : scene.trees) {
    if (tree.has_height && tree.position_m.head<2>().norm() < 10.0) heights.push_back(tree.position_m.z());
  }
  scene.ground_observed = heights.size() >= 3;
  if (!scene.ground_observed) return;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  scene.ground_m = *middle;
}

/// Axes are lines: of a sensor that was mounted steeply tilted (above 45 degrees) they do not say which end is up, but then
/// the stem bases do, which lie below it.
Eigen::Matrix3d upright(const Eigen::Matrix3d& aligned_from_scene, const std::vector<Offer>& offers) {
  constexpr double steep_cosine = 0.7;
  if (aligned_from_scene(2, 2) > steep_cosine) return aligned_from_scene;
  double sum_m = 0.0;
  for (const Offer& offer : offers) sum_m += aligned_from_scene.row(2).dot(offer.position_m);
  const Eigen::Matrix3d overturned = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  return sum_m > 0.0 ? overturned * aligned_from_scene : aligned_from_scene;
}

Scene scene_from(const std::vector<Offer>& offers, std::span<const Eigen::Vector3d> axes, const AlignAxesSettings& settings) {
  Scene scene;
  if (const auto rotation = align_axes(axes, settings)) {
    scene.aligned_from_scene = upright(*rotation, offers);
    scene.tilt_observed = true;
  }
  scene.trees.reserve(offers.size());
  for (const Offer& offer : offers) scene.trees.push_back(tree_from(offer, scene.aligned_from_scene));
  order_trees(scene.trees);
  observe_ground(scene);
  return scene;
}

/// The stems of a list, found by place.
class StemsByX {
public:
  explicit StemsByX(std::span<const Stem> stems) : stems_(stems), order_(stems.size()) {
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return stems_[a].x_m < stems_[b].x_m; });
  }
  double lowest_m() const { return stems_[order_.front()].x_m; }
  double highest_m() const { return stems_[order_.back()].x_m; }
  /// Indices of the stems in a square around a position, in order.
  std::vector<std::size_t> within(const Eigen::Vector3d& center, double radius_m) const {
    const auto before = [&](std::size_t i) { return stems_[i].x_m < center.x() - radius_m; };
    std::vector<std::size_t> found;
    for (auto it = std::partition_point(order_.begin(), order_.end(), before); it != order_.end(); ++it) {
      if (stems_[*it].x_m > center.x() + radius_m) break;
      if (std::abs(stems_[*it].y_m - center.y()) <= radius_m) found.push_back(*it);
    }
    std::sort(found.begin(), found.end());
    return found;
  }

private:
  std::span<const Stem> stems_;
  std::vector<std::size_t> order_;
};

/// Base height of the stem nearest to a position; 0 where none has one.
double ground_near(std::span<const Stem> stems, std::span<const std::size_t> nearby, const Eigen::Vector3d& center) {
  double height_m = 0.0, nearest_sq = std::numeric_limits<double>::max();
  for (const std::size_t i : nearby) {
    const double distance_sq = std::pow(stems[i].x_m - center.x(), 2) + std::pow(stems[i].y_m - center.y(), 2);
    if (stems[i].z_m && distance_sq < nearest_sq) nearest_sq = distance_sq, height_m = *stems[i].z_m;
  }
  return height_m;
}

}  // namespace

Fields PrepareSettings::fields(const std::string& prefix) {
  Fields fields{
      {prefix + ".local_radius_m", "m", "Trees farther than this in x or y are left out", &local_radius_m},
      {prefix + ".min_reconstructed", "", "With fewer reconstructed trees those of preceding frames are added",
       &min_reconstructed},
      {prefix + ".preceding_frames", "", "How many preceding frames may add trees (0: none)", &preceding_frames},
      {prefix + ".search_radius_m", "m", "Preceding frames farther away than this add nothing", &search_radius_m},
      {prefix + ".dedup_radius_m", "m", "An added tree closer than this to one already there is the same tree", &dedup_radius_m},
      {prefix + ".target_tree_count", "", "With fewer trees, candidate stems fill up, best observed first", &target_tree_count}};
  for (Field& field : sensor.fields(prefix + ".sensor")) fields.push_back(std::move(field));
  return fields;
}

Scene prepare_frame_scene(const FrameSet& set, std::size_t index, const PrepareSettings& settings,
                          const AlignAxesSettings& axes_settings) {
  const Frame& frame = set.frames[index];
  std::vector<Eigen::Vector3d> axes;
  for (const Stem& stem : frame.stems) {
    if (stem.axis && stem.number_clusters >= axes_settings.min_clusters && std::abs(stem.x_m) <= settings.local_radius_m &&
        std::abs(stem.y_m) <= settings.local_radius_m) {
      axes.push_back(*stem.axis);
    }
  }
  Scene scene = scene_from(choose_trees(set, index, settings), axes, axes_settings);
  scene.number = frame.number;
  scene.survey_from_scene = frame.pose.survey_from_frame;
  return scene;
}

Scene prepare_cut_scene(std::span<const Stem> stems, std::span<const std::size_t> nearby, const Eigen::Vector3d& center_m,
                        std::int64_t number, const PrepareSettings& settings, const AlignAxesSettings& axes_settings) {
  const RigidTransform scene_from_survey{Eigen::Matrix3d::Identity(), -center_m};
  std::vector<Offer> certain, candidates;
  std::vector<Eigen::Vector3d> axes;
  for (const std::size_t i : nearby) {
    Offer offer = moved_offer(stems[i], scene_from_survey);
    offer.own = true;
    if (!inside(offer.position_m, settings.local_radius_m)) continue;
    if (stems[i].axis) axes.push_back(*stems[i].axis);
    if (stems[i].dbh_for_matching_m()) (stems[i].reconstructed ? certain : candidates).push_back(offer);
  }
  const auto target = static_cast<std::size_t>(std::max(0, settings.target_tree_count));
  std::stable_sort(candidates.begin(), candidates.end(), better_observed);
  candidates.resize(std::min(candidates.size(), target - std::min(target, certain.size())));
  certain.insert(certain.end(), candidates.begin(), candidates.end());
  Scene scene = scene_from(certain, axes, axes_settings);
  scene.number = number;
  scene.survey_from_scene = scene_from_survey.inverse();
  return scene;
}

std::vector<Scene> prepare_frame_scenes(const FrameSet& set, const PrepareSettings& settings, const AlignAxesSettings& axes,
                                        int threads) {
  std::vector<Scene> scenes(set.frames.size());
  parallel_for(scenes.size(), threads, [&](std::size_t i) { scenes[i] = prepare_frame_scene(set, i, settings, axes); });
  mark_level_sensor(scenes, settings.sensor);
  return scenes;
}

std::vector<Scene> prepare_grid_scenes(std::span<const Stem> stems, double spacing_m, int min_trees,
                                       const PrepareSettings& settings, const AlignAxesSettings& axes, int threads) {
  if (stems.empty() || spacing_m <= 0.0) return {};
  const StemsByX by_x(stems);
  const auto [low, high] =
      std::minmax_element(stems.begin(), stems.end(), [](const Stem& a, const Stem& b) { return a.y_m < b.y_m; });
  const auto columns = static_cast<std::size_t>((by_x.highest_m() - by_x.lowest_m()) / spacing_m) + 1;
  const auto rows = static_cast<std::size_t>((high->y_m - low->y_m) / spacing_m) + 1;
  std::vector<std::vector<Scene>> of_column(columns);
  parallel_for(columns, threads, [&](std::size_t column) {
    for (std::size_t row = 0; row < rows; ++row) {
      Eigen::Vector3d center(by_x.lowest_m() + static_cast<double>(column) * spacing_m,
                             low->y_m + static_cast<double>(row) * spacing_m, 0.0);
      const auto nearby = by_x.within(center, settings.local_radius_m);
      if (static_cast<int>(nearby.size()) < min_trees) continue;
      center.z() = ground_near(stems, nearby, center);
      of_column[column].push_back(
          prepare_cut_scene(stems, nearby, center, static_cast<std::int64_t>(column * rows + row), settings, axes));
    }
  });
  std::vector<Scene> scenes;
  for (auto& part : of_column) std::move(part.begin(), part.end(), std::back_inserter(scenes));
  return scenes;
}

}  // namespace stemwise::treeloc
