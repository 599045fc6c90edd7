#include "core/survey/tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/survey/chart_models.hpp"
#include "core/survey/decide_fate.hpp"
#include "core/survey/fusion_choices.hpp"
#include "core/survey/fusion_review.hpp"
#include "core/base/random.hpp"
#include "core/survey/growth.hpp"
#include "tests/core/project/small_project.hpp"

namespace stemwise {
namespace {

using test::aligned_project;
using test::stem_of;

TEST(DeriveTables, GivesOneMatchRowPerTreeAndPairOfConsecutiveSightings) {
  const Tables tables = derive_tables(aligned_project().state());
  EXPECT_EQ(tables.trees.size(), 20u);
  EXPECT_EQ(tables.matches.size(), 40u);
  EXPECT_EQ(tables.observations.size(), 60u);
  EXPECT_NEAR(*tables.matches.front().change_m, 0.01, 1e-12);
  EXPECT_NEAR(*tables.matches.front().years, 5.0, 0.01);
  ASSERT_EQ(tables.growth.size(), 2u);
  EXPECT_EQ(tables.growth[1].n, 20);
  EXPECT_NEAR(tables.growth[1].median_change_m, 0.015, 1e-12);
}

TEST(DeriveTables, MergesByTheSmallestDbhUnlessAnotherPolicyIsChosen) {
  Project project = aligned_project();
  EXPECT_NEAR(*derive_tables(project.state()).trees.front().dbh_m, 0.30, 1e-12);
  project.execute(set_fusion_policy(FusionPolicy::newest));
  const Tables newest = derive_tables(project.state());
  EXPECT_NEAR(*newest.trees.front().dbh_m, 0.325, 1e-12);
  EXPECT_EQ(newest.trees.front().dbh_source, project.state().inventories[2]->id);
  project.execute(set_fusion_policy(FusionPolicy::mean));
  const Tables mean = derive_tables(project.state());
  EXPECT_NEAR(*mean.trees.front().dbh_m, (0.30 + 0.31 + 0.325) / 3.0, 1e-12);
  EXPECT_FALSE(mean.trees.front().dbh_source);  // of no one survey
}

TEST(DeriveTables, BestTakesTheSurveyWithTheLeastDbhErrorAndTheMeanIsWeightedByIt) {
  Project project = aligned_project();
  const auto id = [&](std::size_t i) { return project.state().inventories[i]->id; };
  project.execute(set_dbh_error(id(0), 0.02));
  project.execute(set_dbh_error(id(1), 0.005));
  project.execute(set_dbh_error(id(2), 0.01));
  project.execute(set_fusion_policy(FusionPolicy::best));
  EXPECT_EQ(derive_tables(project.state()).trees.front().dbh_source, id(1));
  EXPECT_NEAR(*derive_tables(project.state()).trees.front().dbh_m, 0.31, 1e-12);
  project.execute(set_fusion_policy(FusionPolicy::mean));
  const double mean_m = (0.30 * 0.25 + 0.31 * 4.0 + 0.325 * 1.0) / 5.25;
  EXPECT_NEAR(*derive_tables(project.state()).trees.front().dbh_m, mean_m, 1e-12);
}

TEST(DeriveTables, AValueComesFromTheSurveyThatAPersonChoseAndByThePolicyAgainWhenTakenBack) {
  Project project = aligned_project();
  const ProjectState before = project.state();
  const TreeId tree = derive_tables(before).trees[3].tree;
  const InventoryId newest = before.inventories[2]->id;
  project.execute(choose_source(tree, FusedAttribute::dbh, newest));
  const Tables chosen = derive_tables(project.state());
  EXPECT_EQ(chosen.find(tree)->dbh_source, newest);
  EXPECT_NEAR(*chosen.find(tree)->dbh_m, 0.355, 1e-12);
  EXPECT_EQ(fusion_choices(project.state()).at(tree).dbh, newest);
  EXPECT_NEAR(*chosen.trees[4].dbh_m, 0.34, 1e-12) << "other trees stay with the policy";
  project.execute(choose_source(tree, FusedAttribute::dbh, std::nullopt));
  EXPECT_EQ(project.state(), before);
  project.undo();
  EXPECT_EQ(derive_tables(project.state()).find(tree)->dbh_source, newest);
  project.undo();
  EXPECT_EQ(project.state(), before);
}

TEST(FusionReview, NamesTreesWhoseSurveysContradictEachOtherAndNoOther) {
  Project project;
  Inventory a = test::grid_inventory("2013", date_from_civil(2013, 7, 1), 20, 0.0), b = test::grid_inventory("2018", date_from_civil(2018, 7, 1), 20, 0.01);
  a.stems[2].species = "Picea abies", b.stems[2].species = "Abies alba";
  a.stems[3].species = "Picea abies", b.stems[3].species = "picea abies";
  b.stems[5].dbh_m = *a.stems[5].dbh_m - 0.15;
  b.stems[7].x_m += 3.0;
  project.execute(add_inventory(a));
  project.execute(add_inventory(b));
  project.execute(apply_alignment(test::straight_alignment(project.state()), {}));
  const auto conflicts = fusion_conflicts(project.state(), derive_tables(project.state()));
  ASSERT_EQ(conflicts.size(), 3u);
  EXPECT_EQ(conflicts[0].attribute, "species");
  EXPECT_EQ(conflicts[0].kept, "Abies alba");
  EXPECT_EQ(conflicts[0].source, project.state().inventories[1]->id);
  EXPECT_EQ(conflicts[1].attribute, "dbh");
  EXPECT_EQ(conflicts[1].values.size(), 2u);
  EXPECT_EQ(conflicts[2].attribute, "position");
}

TEST(FusionReview, GroundThatOneSurveyOfTwoLookedAtIsUnderObserved) {
  Tables tables;
  tables.coverages.push_back({InventoryId{1}, {{{0, 0}, {100, 0}, {100, 100}, {0, 100}}}, 1e4, CoverageSource::drawn});
  tables.coverages.push_back({InventoryId{2}, {{{0, 0}, {40, 0}, {40, 100}, {0, 100}}}, 4e3, CoverageSource::drawn});
  const ObservedGround ground = observed_ground(tables);
  ASSERT_EQ(ground.ha_by_surveys.size(), 2u);
  EXPECT_NEAR(ground.ha_by_surveys[0], 0.6, 1e-9);
  EXPECT_NEAR(ground.ha_by_surveys[1], 0.4, 1e-9);
  EXPECT_EQ(ground.under_observed.size(), 15u);
  for (const ObservedSquare& s : ground.under_observed) EXPECT_GT(s.centre_m.x(), 40.0);
}

TEST(DeriveTables, ShowsARejectedPairAsARowOfItsOwn) {
  Project project = aligned_project();
  project.execute(unlink_stem(stem_of(project, 2, 4), {}));
  const Tables tables = derive_tables(project.state());
  EXPECT_EQ(tables.trees.size(), 21u);
  int rejected = 0;
  for (const MatchRow& row : tables.matches) rejected += row.state == MatchState::rejected;
  EXPECT_GE(rejected, 1);
}

TEST(DeriveTables, ADeadStemsDiameterIsNoGrowthAnywhere) {
  Project project = aligned_project();
  Inventory last = *project.state().inventories[2];
  last.stems[3].status = StemStatus::dead;
  *last.stems[3].dbh_m += 0.5;
  ProjectState state = project.state();
  state.inventories[2] = std::make_shared<const Inventory>(last);
  const Tables tables = derive_tables(state);
  EXPECT_EQ(tables.growth[1].n, 19);
  const auto row = std::find_if(tables.matches.begin(), tables.matches.end(), [&](const MatchRow& m) { return m.b == stem_of(project, 2, 3); });
  ASSERT_NE(row, tables.matches.end());
  EXPECT_FALSE(row->change_m);
  EXPECT_TRUE(row->dbh_b_m);
  EXPECT_TRUE(row->flags.empty());
  const ChartModel chart = growth_distribution_chart(state, tables, state.inventories[1]->id, state.inventories[2]->id);
  EXPECT_TRUE(chart.note.starts_with("19 stems")) << chart.note;
}

TEST(DeriveTables, SaysOfATreesWholeTimeWhetherItGrewWhateverItsLastStepWas) {
  Project project = aligned_project();
  Inventory middle = *project.state().inventories[1];
  *middle.stems[3].dbh_m += 0.30;  // read too large once
  ProjectState state = project.state();
  state.inventories[1] = std::make_shared<const Inventory>(middle);
  const Tables tables = derive_tables(state);
  const TreeRow* tree = tables.find(state.tree_of(stem_of(project, 0, 3)));
  const double change_m = *state.inventories[2]->stems[3].dbh_m - *state.inventories[0]->stems[3].dbh_m;
  EXPECT_EQ(tree->growth_from, state.inventories[0]->id);
  EXPECT_EQ(tree->growth_to, state.inventories[2]->id);
  EXPECT_GT(change_m, 0.0);
  EXPECT_NE(tree->growth, ChangeClass::shrank);
  const auto last = std::find_if(tables.matches.begin(), tables.matches.end(), [&](const MatchRow& m) { return m.b == stem_of(project, 2, 3); });
  EXPECT_EQ(last->change, ChangeClass::shrank);
}

TEST(DeriveTables, AFieldCodeOfAFelledStemMakesItsTreeRemoved) {
  Project project = aligned_project();
  Inventory last = *project.state().inventories[2];
  last.stems[3].status = StemStatus::removed;
  ProjectState state = project.state();
  state.inventories[2] = std::make_shared<const Inventory>(last);
  const Tables tables = derive_tables(state);
  const TreeId felled = state.tree_of(stem_of(project, 2, 3));
  const auto tree = std::find_if(tables.trees.begin(), tables.trees.end(), [&](const TreeRow& t) { return t.tree == felled; });
  ASSERT_NE(tree, tables.trees.end());
  EXPECT_EQ(tree->fate, Fate::removed);
  EXPECT_EQ(tables.growth[1].n, 19);  // a stump's diameter is no growth
}

TEST(DeriveTables, CallsAnApproximateDbhNoDbh) {
  Project project;
  Inventory inventory = test::grid_inventory("a", date_from_civil(2013, 7, 1), 3, 0.0);
  inventory.stems[0].dbh_m.reset();
  inventory.stems[0].dbh_approximation_m = 0.4;
  project.execute(add_inventory(inventory));
  const Tables tables = derive_tables(project.state());
  EXPECT_FALSE(tables.trees[0].dbh_m);
  EXPECT_EQ(tables.observations[0].flags, std::vector<std::string>{"dbh_approximate"});
}

SurveyFootprint square_footprint(double side_m) {
  SurveyFootprint footprint;
  footprint.coverage_in_reference.corners_m = {{0, 0}, {side_m, 0}, {side_m, side_m}, {0, side_m}};
  footprint.position_noise_m = 0.1;
  footprint.smallest_dbh_m = 0.10;
  return footprint;
}

TEST(DecideFate, NeverCallsATreeOutsideCoverageMissingOrDead) {
  const SurveyFootprint from = square_footprint(100), to = square_footprint(50);
  const SurveyStep step{&from, &to, 0.03};
  TreeAtStep tree{{80.0, 80.0}, true};
  EXPECT_EQ(decide_fate(step, tree), Fate::outside_coverage);
  tree.position_in_reference_m = {25.0, 25.0};
  EXPECT_EQ(decide_fate(step, tree), Fate::missing);
  tree.position_in_reference_m = {49.5, 25.0};
  EXPECT_EQ(decide_fate(step, tree), Fate::unresolved);
  tree.by_hand = Fate::dead;
  EXPECT_EQ(decide_fate(step, tree), Fate::dead);
}

TEST(DecideFate, LeavesATreeOpenWhereTheOutlineItselfMayBeOff) {
  const SurveyFootprint from = square_footprint(100);
  SurveyFootprint to = square_footprint(50);
  const TreeAtStep tree{{47.5, 25.0}, true};
  EXPECT_EQ(decide_fate({&from, &to, 0.03}, tree), Fate::missing);
  to.outline_doubt_m = 3.0;
  EXPECT_EQ(decide_fate({&from, &to, 0.03}, tree), Fate::unresolved);
}

TEST(DecideFate, TellsIngrowthFromATreeThatWasMissedBySize) {
  const SurveyFootprint from = square_footprint(100), to = square_footprint(100);
  const SurveyStep step{&from, &to, 0.03};
  TreeAtStep tree{{50.0, 50.0}, false, true};
  tree.dbh_in_to_m = 0.12;
  EXPECT_EQ(decide_fate(step, tree), Fate::ingrowth);
  tree.dbh_in_to_m = 0.40;
  EXPECT_EQ(decide_fate(step, tree), Fate::missed_earlier);
  tree.seen_earlier = true;
  EXPECT_EQ(decide_fate(step, tree), Fate::survivor);
}

TEST(Growth, RecoversTheMeasurementErrorFromTheChangesOfTreesThatBarelyGrow) {
  Random random(4);
  std::vector<double> changes;
  for (int i = 0; i < 4000; ++i) changes.push_back(random.normal(0.01, 0.011 * std::sqrt(2.0)));
  EXPECT_NEAR(dbh_error_from_changes_m(changes), 0.011, 0.001);
}

TEST(Growth, CallsAChangeWithinTwoStandardErrorsWithinError) {
  EXPECT_EQ(classify_change(0.02, 0.01, 0.01), ChangeClass::within_error);
  EXPECT_EQ(classify_change(0.03, 0.01, 0.01), ChangeClass::grew);
  EXPECT_EQ(classify_change(-0.03, 0.01, 0.01), ChangeClass::shrank);
  EXPECT_EQ(classify_change(std::nullopt, 0.01, 0.01), ChangeClass::unknown);
}

}  // namespace
}  // namespace stemwise
