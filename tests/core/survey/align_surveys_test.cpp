#include "core/survey/align_surveys.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <thread>

#include "core/simulate/simulate_forest.hpp"

namespace stemwise {
namespace {

struct Scene3 {
  SimulatedForest forest;
  std::vector<Inventory> inventories;
  std::vector<const Inventory*> pointers() const {
    std::vector<const Inventory*> result;
    for (const auto& inventory : inventories) result.push_back(&inventory);
    return result;
  }
};

Scene3 surveys(const SimulateSettings& settings) {
  Scene3 scene{simulate_forest(settings), {}};
  for (const auto& survey : scene.forest.surveys) {
    scene.inventories.push_back(survey.inventory);
    scene.inventories.back().id = InventoryId{static_cast<std::int64_t>(scene.inventories.size())};
  }
  return scene;
}

SimulateSettings two_years(int stems, std::uint64_t seed) {
  SimulateSettings settings;
  settings.stems = stems;
  settings.seed = seed;
  settings.dates = {date_from_civil(2015, 7, 1), date_from_civil(2020, 7, 1)};
  settings.heights_and_axes = false;
  return settings;
}

SurveyAlignment align(const Scene3& scene, InventoryId reference = {}, int threads = 0, const AlignHints& hints = {}) {
  AlignSettings settings;
  settings.threads = threads;
  return align_surveys(scene.pointers(), reference, settings, hints, {});
}

/// The worst place that the pose gives to a stem, against the truth.
double worst_error_m(const Scene3& scene, const SurveyAlignment& result, std::size_t survey, std::size_t reference) {
  const RigidTransform truth = scene.forest.surveys[reference].truth_from_survey.inverse() * scene.forest.surveys[survey].truth_from_survey;
  double worst = 0.0;
  for (const Stem& stem : scene.inventories[survey].stems) {
    const Eigen::Vector3d p(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
    worst = std::max(worst, (result.inventories[survey].reference_from_inventory * p - truth * p).norm());
  }
  return worst;
}

struct Quality {
  double precision = 0.0, recall = 0.0;
};

Quality match_quality(const Scene3& scene, const SurveyAlignment& result) {
  std::map<StemRef, std::string> tree_of;
  int possible = 0, right = 0, wrong = 0;
  for (const auto& tree : scene.forest.trees) {
    int seen = 0;
    for (std::size_t k = 0; k < scene.inventories.size(); ++k)
      if (!tree.then[k].source_id.empty()) {
        tree_of[{scene.inventories[k].id, std::stoll(tree.then[k].source_id) - 1}] = tree.tree_id;
        ++seen;
      }
    possible += std::max(0, seen - 1);
  }
  for (const Match& match : result.matches) {
    const auto a = tree_of.find(match.a), b = tree_of.find(match.b);
    (a != tree_of.end() && b != tree_of.end() && a->second == b->second ? right : wrong)++;
  }
  return {right / std::max(1.0, static_cast<double>(right + wrong)), right / std::max(1.0, static_cast<double>(possible))};
}

TEST(AlignSurveys, finds_pose_and_matches_of_two_plain_lists_at_any_yaw) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Scene3 scene = surveys(two_years(120, seed));
    const auto result = align(scene, InventoryId{1});
    ASSERT_EQ(result.inventories[1].status, AlignmentStatus::aligned) << result.inventories[1].reason;
    EXPECT_LT(worst_error_m(scene, result, 1, 0), 0.25);
    const Quality quality = match_quality(scene, result);
    EXPECT_GT(quality.precision, 0.97);
    EXPECT_GT(quality.recall, 0.97);
    EXPECT_TRUE(result.inventories[1].observed[Dof::yaw]);
    EXPECT_FALSE(result.inventories[1].observed[Dof::z]);
  }
}

TEST(AlignSurveys, aligns_three_years_and_keeps_one_stem_of_each_in_a_tree) {
  SimulateSettings settings;
  settings.stems = 200;
  settings.heights_and_axes = false;
  const Scene3 scene = surveys(settings);
  const auto result = align(scene);
  for (const auto& report : result.inventories) EXPECT_TRUE(report.status == AlignmentStatus::aligned || report.status == AlignmentStatus::reference);
  const Quality quality = match_quality(scene, result);
  EXPECT_GT(quality.precision, 0.97);
  EXPECT_GT(quality.recall, 0.96);
  std::map<StemRef, std::array<int, 2>> uses;  // as the earlier and as the later of a match
  for (const Match& match : result.matches) ++uses[match.a][0], ++uses[match.b][1];
  for (const auto& [stem, count] : uses) {
    EXPECT_LE(count[0], 1);
    EXPECT_LE(count[1], 1);
  }
}

TEST(AlignSurveys, adds_a_survey_to_a_base_without_touching_it) {
  SimulateSettings settings;
  settings.stems = 150;
  settings.seed = 5;
  settings.heights_and_axes = false;
  for (const int year : {2011, 2015, 2019}) settings.dates.push_back(date_from_civil(year, 7, 1));
  for (const std::size_t added : {1u, 2u}) {  // in between, and at the end
    const Scene3 scene = surveys(settings);
    Scene3 first = scene;
    first.inventories.erase(first.inventories.begin() + static_cast<std::ptrdiff_t>(added));
    const SurveyAlignment before = align(first, InventoryId{1});
    AlignHints hints;
    hints.base.poses = before.inventories;
    std::map<StemRef, StemRef> later_of;
    for (const Match& match : before.matches) later_of[match.a] = match.b;
    std::set<StemRef> joined;
    for (const auto& [a, b] : later_of) hints.base.trees.push_back({a, b}), joined.insert(a), joined.insert(b);
    for (const Inventory& inventory : first.inventories)
      for (std::size_t i = 0; i < inventory.stems.size(); ++i)
        if (const StemRef stem{inventory.id, static_cast<std::int64_t>(i)}; !joined.contains(stem)) hints.base.trees.push_back({stem});
    const SurveyAlignment after = align(scene, InventoryId{1}, 0, hints);
    EXPECT_EQ(after.inventories[added].status, AlignmentStatus::aligned);
    EXPECT_LT(worst_error_m(scene, after, added, 0), 0.25);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(after.inventories[k < added ? k : k + 1], before.inventories[k]);
    std::map<StemRef, std::set<StemRef>> trees_met;  // no stem of the added survey joins two trees of the base
    for (const Match& match : after.matches) {
      const InventoryId id = scene.inventories[added].id;
      ASSERT_TRUE(match.a.inventory == id || match.b.inventory == id);
      const StemRef own = match.a.inventory == id ? match.a : match.b, other = match.a.inventory == id ? match.b : match.a;
      const auto earlier = std::find_if(later_of.begin(), later_of.end(), [&](const auto& e) { return e.second == other; });
      trees_met[own].insert(earlier == later_of.end() ? other : earlier->first);
    }
    for (const auto& [stem, trees] : trees_met) EXPECT_EQ(trees.size(), 1u);
    SurveyAlignment all = after;
    all.matches.insert(all.matches.end(), before.matches.begin(), before.matches.end());
    EXPECT_GT(match_quality(scene, all).recall, 0.95);
  }
}

TEST(AlignSurveys, observes_tilt_and_height_where_both_surveys_have_axes_and_base_heights) {
  SimulateSettings settings = two_years(200, 4);
  settings.heights_and_axes = true;
  settings.tilt_deg = 8.0;
  const Scene3 scene = surveys(settings);
  const auto result = align(scene, InventoryId{1});
  ASSERT_EQ(result.inventories[1].status, AlignmentStatus::aligned) << result.inventories[1].reason;
  for (const Dof dof : {Dof::x, Dof::y, Dof::yaw, Dof::z, Dof::roll, Dof::pitch}) EXPECT_TRUE(result.inventories[1].observed[dof]);
  EXPECT_LT(worst_error_m(scene, result, 1, 0), 0.6) << (result.notes.empty() ? "" : result.notes.front());
}

TEST(AlignSurveys, refuses_a_mirrored_list_and_says_so) {
  Scene3 scene = surveys(two_years(120, 5));
  for (Stem& stem : scene.inventories[1].stems) stem.x_m = -stem.x_m;
  const auto result = align(scene);
  const auto& report = result.inventories[result.reference == InventoryId{1} ? 1 : 0];
  EXPECT_EQ(report.status, AlignmentStatus::failed);
  EXPECT_NE(report.reason.find("mirrored"), std::string::npos) << report.reason;
  EXPECT_TRUE(result.matches.empty());
}

TEST(AlignSurveys, refuses_another_forest_with_a_reason) {
  Scene3 scene = surveys(two_years(120, 6));
  scene.inventories[1].stems = surveys(two_years(120, 7)).inventories[1].stems;
  const auto result = align(scene, InventoryId{1});
  EXPECT_EQ(result.inventories[1].status, AlignmentStatus::failed);
  EXPECT_NE(result.inventories[1].reason.find("no pose stands out"), std::string::npos) << result.inventories[1].reason;
}

TEST(AlignSurveys, refuses_two_unrelated_plantations_of_one_spacing) {
  SimulateSettings settings = two_years(196, 8);
  settings.planted = true;
  Scene3 scene = surveys(settings);
  settings.seed = 9;
  scene.inventories[1].stems = surveys(settings).inventories[1].stems;
  EXPECT_EQ(align(scene, InventoryId{1}).inventories[1].status, AlignmentStatus::failed);
}

TEST(AlignSurveys, needs_no_diameters) {
  Scene3 scene = surveys(two_years(150, 10));
  for (auto& inventory : scene.inventories)
    for (Stem& stem : inventory.stems) stem.dbh_m.reset();
  const auto result = align(scene, InventoryId{1});
  ASSERT_EQ(result.inventories[1].status, AlignmentStatus::aligned) << result.inventories[1].reason;
  EXPECT_LT(worst_error_m(scene, result, 1, 0), 0.25);
  EXPECT_GT(match_quality(scene, result).precision, 0.95);
}

TEST(AlignSurveys, survives_diameters_read_in_the_wrong_unit) {
  Scene3 scene = surveys(two_years(150, 11));
  for (Stem& stem : scene.inventories[1].stems) stem.dbh_m = *stem.dbh_m * 3.14159;  // girths taken for diameters
  const auto result = align(scene, InventoryId{1});
  ASSERT_EQ(result.inventories[1].status, AlignmentStatus::aligned) << result.inventories[1].reason;
  EXPECT_LT(worst_error_m(scene, result, 1, 0), 0.25);
}

TEST(AlignSurveys, loses_nothing_at_utm_sized_coordinates) {
  Scene3 scene = surveys(two_years(120, 12));
  const auto near = align(scene, InventoryId{1});
  for (Stem& stem : scene.inventories[1].stems) stem.x_m += 500000.0, stem.y_m += 5200000.0;
  const auto far = align(scene, InventoryId{1});
  ASSERT_EQ(far.inventories[1].status, AlignmentStatus::aligned);
  const Eigen::Vector3d shift(500000.0, 5200000.0, 0.0);
  for (const Stem& stem : scene.inventories[1].stems) {
    const Eigen::Vector3d p(stem.x_m, stem.y_m, 0.0);
    EXPECT_LT((far.inventories[1].reference_from_inventory * p - near.inventories[1].reference_from_inventory * (p - shift)).norm(), 2e-3);
  }
}

TEST(AlignSurveys, gives_the_same_verdict_and_the_inverse_pose_when_swapped) {
  const Scene3 scene = surveys(two_years(120, 13));
  const auto forth = align(scene, InventoryId{1}), back = align(scene, InventoryId{2});
  EXPECT_EQ(forth.inventories[1].status, back.inventories[0].status);
  EXPECT_DOUBLE_EQ(forth.inventories[1].acceptance.log_likelihood_ratio, back.inventories[0].acceptance.log_likelihood_ratio);
  EXPECT_DOUBLE_EQ(forth.inventories[1].acceptance.mirror, back.inventories[0].acceptance.mirror);
  const RigidTransform round = forth.inventories[1].reference_from_inventory * back.inventories[0].reference_from_inventory;
  for (const Stem& stem : scene.inventories[0].stems) {
    const Eigen::Vector3d p(stem.x_m, stem.y_m, 0.0);
    EXPECT_LT((round * p - p).norm(), 0.1);
  }
}

TEST(AlignSurveys, gives_the_same_result_with_one_thread_and_with_four) {
  const Scene3 scene = surveys(two_years(200, 14));
  const auto one = align(scene, {}, 1), four = align(scene, {}, 4);
  EXPECT_EQ(one.inventories, four.inventories);
  EXPECT_EQ(one.matches, four.matches);
  EXPECT_EQ(one.pairs, four.pairs);
}

/// Five trees in common are too few to prove a pose.
Scene3 hardly_overlapping() {
  Scene3 scene = surveys(two_years(60, 15));
  auto& stems = scene.inventories[1].stems;
  const auto other = surveys(two_years(60, 16)).inventories[1].stems;
  std::vector<Stem> mixed(stems.begin(), stems.begin() + 5);
  for (std::size_t i = 0; i < 40; ++i) {
    mixed.push_back(other[i]);
    mixed.back().x_m += 120.0;
  }
  stems = mixed;
  return scene;
}

TEST(AlignSurveys, takes_two_pairs_named_by_a_person_as_the_pose) {
  const Scene3 scene = hardly_overlapping();
  ASSERT_EQ(align(scene, InventoryId{1}).inventories[1].status, AlignmentStatus::failed);
  AlignHints hints;
  for (const auto& tree : scene.forest.trees) {
    if (tree.then[0].source_id.empty() || tree.then[1].source_id.empty() || std::stoi(tree.then[1].source_id) > 5) continue;
    hints.same_tree.push_back({{InventoryId{1}, std::stoll(tree.then[0].source_id) - 1}, {InventoryId{2}, std::stoll(tree.then[1].source_id) - 1}});
  }
  ASSERT_GE(hints.same_tree.size(), 2U);
  const auto result = align(scene, InventoryId{1}, 0, hints);
  EXPECT_EQ(result.inventories[1].status, AlignmentStatus::aligned);
  std::set<std::pair<StemRef, StemRef>> joined;
  for (const Match& match : result.matches) joined.insert({match.a, match.b});
  for (const auto& pair : hints.same_tree) EXPECT_TRUE(joined.contains({pair.a, pair.b}));
}

/// Matches of an alignment as a person would name them.
AlignHints named_pairs(const SurveyAlignment& alignment, std::size_t count) {
  AlignHints hints;
  for (std::size_t k = 0; hints.same_tree.size() < count; k += 7) hints.same_tree.push_back({alignment.matches[k].a, alignment.matches[k].b});
  return hints;
}

TEST(AlignSurveys, refuses_named_pairs_that_a_far_better_pose_contradicts) {
  const Scene3 scene = surveys(two_years(120, 17));
  AlignHints hints = named_pairs(align(scene, InventoryId{1}), 2);
  std::swap(hints.same_tree[0].b, hints.same_tree[1].b);  // the two trees changed places: equally far apart
  const auto result = align(scene, InventoryId{1}, 0, hints);
  EXPECT_EQ(result.inventories[1].status, AlignmentStatus::failed);
  EXPECT_NE(result.inventories[1].reason.find("named pairs"), std::string::npos) << result.inventories[1].reason;
}

TEST(AlignSurveys, names_the_pair_that_the_other_named_pairs_contradict) {
  const Scene3 scene = surveys(two_years(120, 17));
  const auto before = align(scene, InventoryId{1});
  AlignHints hints = named_pairs(before, 4);
  hints.same_tree[1].b = before.matches[60].b;
  const auto result = align(scene, InventoryId{1}, 0, hints);
  EXPECT_EQ(result.inventories[1].status, AlignmentStatus::aligned);
  const auto named = std::count_if(result.notes.begin(), result.notes.end(), [](const std::string& note) { return note.find("named as the same tree") != std::string::npos; });
  EXPECT_EQ(named, 1);
  const RigidTransform step = before.inventories[1].reference_from_inventory.inverse() * result.inventories[1].reference_from_inventory;
  EXPECT_LT(step.translation_m.norm(), 0.5);
}

TEST(AlignSurveys, never_joins_what_a_person_has_separated) {
  const Scene3 scene = surveys(two_years(120, 17));
  const auto before = align(scene, InventoryId{1});
  AlignHints hints;
  for (std::size_t k = 0; k < 5; ++k) hints.not_same.push_back({before.matches[k].a, before.matches[k].b});
  for (const Match& match : align(scene, InventoryId{1}, 0, hints).matches)
    for (const auto& pair : hints.not_same) EXPECT_FALSE(match.a == pair.a && match.b == pair.b);
}

TEST(AlignSurveys, refuses_lists_of_two_stems_without_a_fuss) {
  Scene3 scene = surveys(two_years(60, 18));
  scene.inventories[1].stems.resize(2);
  const auto result = align(scene);
  EXPECT_EQ(result.inventories[1].status, AlignmentStatus::failed);
  EXPECT_FALSE(result.inventories[1].reason.empty());
}

TEST(AlignSurveys, stops_when_asked_to) {
  const Scene3 scene = surveys(two_years(120, 19));
  const std::atomic<bool> cancel = true;
  EXPECT_THROW(align_surveys(scene.pointers(), {}, {}, {}, Progress({}, &cancel)), Cancelled);
}

}  // namespace
}  // namespace stemwise
