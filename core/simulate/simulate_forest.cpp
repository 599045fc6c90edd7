#include "core/simulate/simulate_forest.hpp"

#include <algorithm>
#include <cmath>

#include "core/simulate/drift.hpp"
#include "core/simulate/grow_stand.hpp"
#include "core/simulate/observe_stand.hpp"

namespace stemwise {
namespace {

// Each part of the work draws from a stream of its own, so that an option of one does not change the others.
enum Stream : std::uint64_t { terrain_stream = 1, stand_stream = 2, years_stream = 100, frame_stream = 200, observe_stream = 300, walk_stream = 400 };

std::vector<Date> dates_of(const SimulateSettings& settings) {
  if (!settings.dates.empty()) return settings.dates;
  return {date_from_civil(2015, 7, 1), date_from_civil(2019, 7, 1), date_from_civil(2023, 7, 1)};
}

void number_trees(std::vector<TrueTree>& trees) {
  for (std::size_t i = 0; i < trees.size(); ++i) trees[i].tree_id = "T" + std::to_string(i + 1);
}

/// The list's stems as trees that are there "before".
std::vector<TrueTree> trees_of(const Inventory& inventory) {
  std::vector<TrueTree> trees;
  for (const Stem& stem : inventory.stems) {
    if (!is_living(stem.status) || !std::isfinite(stem.x_m) || !std::isfinite(stem.y_m)) continue;
    TrueTree tree;
    tree.tree_id = stem.source_id;
    tree.x_m = stem.x_m, tree.y_m = stem.y_m, tree.z_m = stem.z_m.value_or(0.0);
    tree.axis = stem.axis.value_or(Eigen::Vector3d::UnitZ());
    tree.species = stem.species;
    tree.then.push_back({TrueState::alive, 100.0 * stem.dbh_for_matching_m().value_or(0.2), stem.source_id});
    trees.push_back(tree);
  }
  return trees;
}

SimulatedSurvey moved_frames(const Inventory& inventory, const RigidTransform& truth_from_survey, const SimulateSettings& settings) {
  SimulatedSurvey result{inventory, truth_from_survey};
  const RigidTransform survey_from_truth = truth_from_survey.inverse();
  FrameSet frames = *inventory.frames;
  for (Frame& frame : frames.frames) frame.pose.survey_from_frame = survey_from_truth * frame.pose.survey_from_frame;
  result.inventory.frames = std::make_shared<const FrameSet>(with_drift(std::move(frames), settings.drift, settings.seed));
  result.inventory.stems.clear();
  return result;
}

}  // namespace

std::string true_fate(const TrueTree& tree, std::size_t survey) {
  switch (tree.then[survey].state) {
    case TrueState::not_yet: return "not_yet";
    case TrueState::dead: return "dead";
    case TrueState::removed: return "removed";
    case TrueState::alive: break;
  }
  return survey > 0 && tree.then[survey - 1].state == TrueState::not_yet ? "ingrowth" : "survivor";
}

SimulatedForest simulate_forest(const SimulateSettings& settings, const Progress& progress) {
  const double side_m = 100.0 * std::sqrt(settings.area_ha > 0.0 ? settings.area_ha : settings.stems / 450.0);
  Random for_terrain(settings.seed, terrain_stream), for_stand(settings.seed, stand_stream);
  const Terrain terrain = random_terrain(settings.terrain_relief_m, for_terrain);
  SimulatedForest forest;
  forest.trees = first_stand(settings, side_m, terrain, for_stand);
  const auto dates = dates_of(settings);
  for (std::size_t k = 1; k < dates.size(); ++k) {
    progress.at(0.5 * static_cast<double>(k) / static_cast<double>(dates.size()), "Growing the forest");
    Random random(settings.seed, years_stream + k);
    let_years_pass(forest.trees, years_between(dates[k - 1], dates[k]), settings, &terrain, random);
  }
  number_trees(forest.trees);
  for (std::size_t k = 0; k < dates.size(); ++k) {
    progress.at(0.5 + 0.5 * static_cast<double>(k) / static_cast<double>(dates.size()), "Surveying it");
    Random for_frame(settings.seed, frame_stream + k), for_view(settings.seed, observe_stream + k), for_walk(settings.seed, walk_stream + k);
    const RigidTransform truth_from_survey = random_frame(settings, for_frame);
    forest.surveys.push_back(observe_stand(forest.trees, k, dates[k], truth_from_survey, settings, for_view));
    if (settings.frames)
      forest.surveys.back().inventory.frames = std::make_shared<const FrameSet>(with_drift(walk_through(forest.trees, k, truth_from_survey, settings, for_walk), settings.drift, settings.seed + k));
  }
  return forest;
}

SimulatedForest simulate_resurvey(const Inventory& inventory, const SimulateSettings& settings) {
  const Date before = inventory.date.value_or(Date{});
  const Date after = !settings.dates.empty() ? settings.dates.front() : Date{before.days + static_cast<int>(5 * 365.25)};
  Random for_frame(settings.seed, frame_stream), for_years(settings.seed, years_stream), for_view(settings.seed, observe_stream);
  SimulateSettings adapted = settings;
  adapted.heights_and_axes = std::any_of(inventory.stems.begin(), inventory.stems.end(), [](const Stem& s) { return s.z_m || s.axis; });
  if (!adapted.heights_and_axes && !inventory.frames) adapted.tilt_deg = 0.0;  // a flat list cannot be tilted, only squeezed
  RigidTransform truth_from_survey = random_frame(adapted, for_frame);
  SimulatedForest forest;
  forest.trees = trees_of(inventory);
  if (inventory.frames) {
    forest.surveys.push_back(moved_frames(inventory, truth_from_survey, settings));
    return forest;
  }
  if (!forest.trees.empty()) {  // turn about the list's own place, so that UTM-sized lists keep their size
    const Eigen::Vector3d here(forest.trees[0].x_m, forest.trees[0].y_m, forest.trees[0].z_m);
    truth_from_survey.translation_m += here - truth_from_survey.rotation * here;
  }
  const std::size_t original = forest.trees.size();
  let_years_pass(forest.trees, inventory.date ? years_between(before, after) : 5.0, adapted, nullptr, for_years);
  for (std::size_t k = original; k < forest.trees.size(); ++k) forest.trees[k].tree_id = "ingrowth-" + std::to_string(k - original + 1);
  forest.surveys.push_back(observe_stand(forest.trees, 1, after, truth_from_survey, adapted, for_view));
  if (!inventory.date && settings.dates.empty()) {
    forest.surveys.back().inventory.date.reset();
    for (Stem& stem : forest.surveys.back().inventory.stems) stem.date.reset();
  }
  forest.surveys.back().inventory.name = "resurvey";
  return forest;
}

}  // namespace stemwise
