#include "core/simulate/simulate_forest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace stemwise {
namespace {

std::map<std::string, const Stem*> by_id(const Inventory& inventory) {
  std::map<std::string, const Stem*> result;
  for (const auto& stem : inventory.stems) result[stem.source_id] = &stem;
  return result;
}

TEST(SimulateForest, is_the_same_for_the_same_seed_and_another_for_another) {
  SimulateSettings settings;
  settings.stems = 120;
  const auto once = simulate_forest(settings), again = simulate_forest(settings);
  EXPECT_EQ(once.surveys[1].inventory, again.surveys[1].inventory);
  settings.seed = 1;
  EXPECT_NE(once.surveys[1].inventory, simulate_forest(settings).surveys[1].inventory);
}

TEST(SimulateForest, puts_every_recorded_stem_where_the_truth_says_within_its_noise) {
  SimulateSettings settings;
  settings.stems = 300;
  settings.tilt_deg = 8.0;
  const auto forest = simulate_forest(settings);
  ASSERT_EQ(forest.surveys.size(), 3U);
  for (std::size_t k = 0; k < forest.surveys.size(); ++k) {
    const auto stems = by_id(forest.surveys[k].inventory);
    int found = 0;
    for (const auto& tree : forest.trees) {
      ASSERT_EQ(tree.then.size(), 3U);
      if (tree.then[k].source_id.empty()) continue;
      const Stem& stem = *stems.at(tree.then[k].source_id);
      const Eigen::Vector3d p = forest.surveys[k].truth_from_survey * Eigen::Vector3d(stem.x_m, stem.y_m, *stem.z_m);
      EXPECT_LT((p - Eigen::Vector3d(tree.x_m, tree.y_m, tree.z_m)).norm(), 0.8);
      EXPECT_NEAR(100.0 * *stem.dbh_m, tree.then[k].dbh_cm, 6.0);
      ++found;
    }
    EXPECT_GT(found, 200);
  }
}

TEST(SimulateForest, lets_trees_grow_in_die_and_be_felled) {
  SimulateSettings settings;
  settings.stems = 800;
  std::map<std::string, int> fates;
  for (const auto& tree : simulate_forest(settings).trees) ++fates[true_fate(tree, 2)];
  EXPECT_GT(fates["survivor"], 600);
  EXPECT_GT(fates["ingrowth"], 10);
  EXPECT_GT(fates["dead"], 10);
  EXPECT_GT(fates["removed"], 5);
}

TEST(SimulateForest, keeps_stems_apart_as_a_stand_does) {
  SimulateSettings settings;
  settings.stems = 450;
  const auto forest = simulate_forest(settings);
  int close = 0;
  for (std::size_t i = 0; i < forest.trees.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::hypot(forest.trees[i].x_m - forest.trees[j].x_m, forest.trees[i].y_m - forest.trees[j].y_m) < 0.6) ++close;
  EXPECT_LT(close, 40);  // second stems, and few besides
}

TEST(SimulateForest, gives_frames_that_show_the_trees_of_the_survey) {
  SimulateSettings settings;
  settings.stems = 200;
  settings.frames = true;
  const auto forest = simulate_forest(settings);
  const auto& frames = forest.surveys[0].inventory.frames->frames;
  ASSERT_GT(frames.size(), 10U);
  const Frame& frame = frames[frames.size() / 2];
  ASSERT_GT(frame.stems.size(), 5U);
  for (const Stem& stem : frame.stems) {
    const Eigen::Vector3d p = forest.surveys[0].truth_from_survey * (frame.pose.survey_from_frame * Eigen::Vector3d(stem.x_m, stem.y_m, *stem.z_m));
    double nearest = 1e9;
    for (const auto& tree : forest.trees) nearest = std::min(nearest, (p - Eigen::Vector3d(tree.x_m, tree.y_m, tree.z_m)).norm());
    EXPECT_LT(nearest, 0.8);
  }
}

TEST(SimulateResurvey, moves_a_real_list_and_keeps_who_is_who) {
  Inventory before;
  for (int i = 0; i < 200; ++i) {
    Stem stem;
    stem.source_id = "s" + std::to_string(i);
    stem.x_m = 500000.0 + 7.0 * (i % 20), stem.y_m = 5200000.0 + 6.0 * (i / 20);
    stem.dbh_m = 0.1 + 0.002 * i;
    before.stems.push_back(stem);
  }
  before.date = date_from_civil(2010, 1, 1);
  SimulateSettings settings;
  settings.dates = {date_from_civil(2016, 1, 1)};
  const auto next = simulate_resurvey(before, settings);
  ASSERT_EQ(next.surveys.size(), 1U);
  const auto stems = by_id(next.surveys[0].inventory);
  int kept = 0;
  for (const auto& tree : next.trees) {
    if (tree.then[1].source_id.empty() || tree.then[0].state != TrueState::alive) continue;
    const Stem& stem = *stems.at(tree.then[1].source_id);
    EXPECT_FALSE(stem.z_m.has_value());
    const Eigen::Vector3d p = next.surveys[0].truth_from_survey * Eigen::Vector3d(stem.x_m, stem.y_m, 0.0);
    EXPECT_LT(std::hypot(p.x() - tree.x_m, p.y() - tree.y_m), 0.6);
    ++kept;
  }
  EXPECT_GT(kept, 140);
}

}  // namespace
}  // namespace stemwise
