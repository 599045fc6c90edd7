#include "core/project/commands.hpp"
#include "core/geodesy/georeference.hpp"
#include "core/geometry/rigid_transform.hpp"
#include "core/project/commands/match_editor.hpp"
#include "core/project/regroup_commands.hpp"
#include "core/project/rough_pose_key.hpp"
#include "core/survey/tables.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <stdexcept>

#include "tests/core/project/small_project.hpp"

namespace stemwise {
namespace {

using test::aligned_project;
using test::stem_of;

struct Case {
  std::string name;
  std::function<CommandPtr(const Project&)> make;
};

const EditStamp stamp{"Ada", "2026-11-22T10:00:00Z", "seen in the field"};

const Georeference anchor{GeoreferenceKind::anchor, {48.0, 9.0, 400.0}, {0, 0, 0}, 12.0, 0, 0.5, "anchor"};

std::shared_ptr<const Inventory> remade(const Project& p, std::size_t index, int trees) {
  Inventory inventory = test::grid_inventory("made anew", date_from_civil(2019, 1, 1), trees, 0.0);
  inventory.id = p.state().inventories[index]->id;
  return std::make_shared<const Inventory>(std::move(inventory));
}

std::vector<Case> every_command() {
  return {
      {"AddInventory", [](const Project&) { return add_inventory(test::grid_inventory("2023", date_from_civil(2024, 7, 1), 5, 0.0)); }},
      {"RemoveInventory", [](const Project& p) { return remove_inventory(p.state().inventories[1]->id); }},
      {"RemoveReference", [](const Project& p) { return remove_inventory(p.state().reference); }},
      {"RenameInventory", [](const Project& p) { return rename_inventory(p.state().inventories[1]->id, "second"); }},
      {"SetDate", [](const Project& p) { return set_inventory_date(p.state().inventories[1]->id, std::nullopt); }},
      {"ReplaceInventory", [](const Project& p) { return replace_inventory(remade(p, 1, 17)); }},
      {"ReplaceReferenceByFewer", [](const Project& p) { return replace_inventory(remade(p, 0, 5)); }},
      {"SetReference", [](const Project& p) { return set_reference(p.state().inventories[2]->id); }},
      {"ApplyAlignment", [](const Project& p) { return apply_alignment(test::straight_alignment(p.state()), {}); }},
      {"AcceptMatch", [](const Project& p) { return accept_match(stem_of(p, 0, 3), stem_of(p, 1, 3), stamp); }},
      {"RejectMatch", [](const Project& p) { return reject_match(stem_of(p, 0, 3), stem_of(p, 1, 3), stamp); }},
      {"RejectLastMatch", [](const Project& p) { return reject_match(stem_of(p, 1, 3), stem_of(p, 2, 3), stamp); }},
      {"LinkAcrossTrees", [](const Project& p) { return link_stems(stem_of(p, 0, 3), stem_of(p, 1, 4), stamp); }},
      {"LinkWithinTree", [](const Project& p) { return link_stems(stem_of(p, 0, 3), stem_of(p, 1, 3), stamp); }},
      {"UnlinkMiddle", [](const Project& p) { return unlink_stem(stem_of(p, 1, 3), stamp); }},
      {"SwapStems", [](const Project& p) { return swap_stems(stem_of(p, 1, 3), stem_of(p, 1, 4), stamp); }},
      {"SplitTree", [](const Project& p) { return split_tree(stem_of(p, 1, 3), stamp); }},
      {"SplitAndMerge",
       [](const Project& p) {
         std::vector<CommandPtr> parts;
         parts.push_back(split_tree(stem_of(p, 2, 3), stamp));
         parts.push_back(merge_trees(p.state().tree_of(stem_of(p, 0, 3)), TreeId{p.state().next_tree}, stamp));
         return group("Split and merge", std::move(parts));
       }},
      {"SetFate", [](const Project& p) { return set_fate(p.state().tree_of(stem_of(p, 0, 3)), Fate::removed, stamp); }},
      {"SetNote", [](const Project& p) { return set_tree_note(p.state().tree_of(stem_of(p, 0, 3)), "fork", stamp); }},
      {"LogDecision", [](const Project&) { return log_decision("Accept the pose of 2018", "probable", "accepted", stamp); }},
      {"SetGeoreference", [](const Project&) { return set_georeference(anchor); }},
      {"SetFusion", [](const Project&) { return set_fusion_policy(FusionPolicy::mean); }},
      {"SetCoverage", [](const Project& p) { return set_coverage(p.state().reference, {{{{0, 0}, {9, 0}, {9, 9}}}, CoverageSource::drawn}); }},
      {"SetDbhError", [](const Project& p) { return set_dbh_error(p.state().reference, 0.012); }},
      {"SetSetting", [](const Project&) { return set_setting("seed", "3"); }},
      {"SetTitle", [](const Project&) { return set_title("Stand 14"); }},
      {"Group",
       [](const Project& p) {
         std::vector<CommandPtr> parts;
         parts.push_back(unlink_stem(stem_of(p, 1, 3), stamp));
         parts.push_back(link_stems(stem_of(p, 1, 3), stem_of(p, 0, 3), stamp));
         return group("Relink", std::move(parts));
       }},
  };
}

class EveryCommand : public testing::TestWithParam<Case> {};

TEST_P(EveryCommand, AppliedRevertedAndAppliedAgainIsAppliedAndRevertingRestoresEquality) {
  const Project project = aligned_project();
  ProjectState state = project.state();
  const CommandPtr command = GetParam().make(project);
  command->apply(state);
  const ProjectState applied = state;
  EXPECT_FALSE(command->label().empty());
  command->revert(state);
  EXPECT_EQ(state, project.state());
  command->apply(state);
  EXPECT_EQ(state, applied);
}

bool is_stem(const ProjectState& state, StemRef stem) { return state.find(stem) != nullptr; }

/// Everything that a project names is in it: else its file could not be read again.
TEST_P(EveryCommand, LeavesNothingThatNamesWhatIsGone) {
  const Project project = aligned_project();
  ProjectState state = project.state();
  for (auto& [pair, match] : state.matches) {  // each knows a second choice in the other surveys
    match.second_choice = stem_of(project, 1, 0);
    match.second_distance_m = 1.0;
  }
  GetParam().make(project)->apply(state);
  for (const auto& [pair, match] : state.matches) {
    EXPECT_TRUE(is_stem(state, pair.first) && is_stem(state, pair.second));
    EXPECT_EQ(match.second_choice.has_value(), match.second_distance_m.has_value());
    EXPECT_TRUE(!match.second_choice || is_stem(state, *match.second_choice));
  }
  for (const auto& [id, tree] : state.trees)
    for (const StemRef& stem : tree.stems) EXPECT_TRUE(is_stem(state, stem));
  for (const auto& [id, alignment] : state.alignments) EXPECT_NE(state.find(id), nullptr);
  for (const auto& [id, coverage] : state.coverages) EXPECT_NE(state.find(id), nullptr);
  for (const auto& [id, error_m] : state.dbh_error_m) EXPECT_NE(state.find(id), nullptr);
  for (const PairReport& pair : state.pairs) EXPECT_TRUE(state.find(pair.a) != nullptr && state.find(pair.b) != nullptr);
  EXPECT_TRUE(state.inventories.empty() || state.find(state.reference) != nullptr);
}

TEST(EditCommand, IsCalledWhatItWritesIntoTheLogWithTheStemsNames) {
  Project project = aligned_project();
  const StemRef a = stem_of(project, 0, 3), b = stem_of(project, 1, 3);
  const TreeId tree = project.state().tree_of(a);
  project.execute(accept_match(a, b, stamp));
  EXPECT_EQ(project.undo_label(), "Accept " + stem_label(project.state(), a) + " and " + stem_label(project.state(), b));
  EXPECT_EQ(project.undo_label(), project.state().edit_log.back().what);
  project.execute(set_fate(tree, Fate::outside_coverage, stamp));
  EXPECT_EQ(project.undo_label(), "Mark " + tree_label(tree) + " as outside coverage");
  project.undo();
  EXPECT_EQ(project.redo_label(), "Mark " + tree_label(tree) + " as outside coverage");
}

TEST_P(EveryCommand, LeavesEveryStemInExactlyOneTreeThatHoldsItOncePerInventory) {
  const Project project = aligned_project();
  ProjectState state = project.state();
  GetParam().make(project)->apply(state);
  std::size_t stems_in_trees = 0, stems_in_inventories = 0;
  for (const auto& [id, tree] : state.trees) {
    std::set<InventoryId> seen;
    for (const StemRef& stem : tree.stems) {
      EXPECT_TRUE(seen.insert(stem.inventory).second);
      EXPECT_EQ(state.tree_of(stem), id);
    }
    EXPECT_FALSE(tree.stems.empty());
    stems_in_trees += tree.stems.size();
  }
  for (const auto& inventory : state.inventories)
    if (state.is_placed(inventory->id)) stems_in_inventories += inventory->stems.size();
  EXPECT_EQ(stems_in_trees, stems_in_inventories);
}

INSTANTIATE_TEST_SUITE_P(Law, EveryCommand, testing::ValuesIn(every_command()), [](const auto& param) { return param.param.name; });

TEST(SwapStems, BothGoToTheOthersTreeAndStayThereInALaterRun) {
  Project project = aligned_project();
  const StemRef a = stem_of(project, 1, 3), b = stem_of(project, 1, 4);
  const TreeId tree_a = project.state().tree_of(a), tree_b = project.state().tree_of(b);
  project.execute(swap_stems(a, b, stamp));
  EXPECT_EQ(project.state().tree_of(a), tree_b);
  EXPECT_EQ(project.state().tree_of(b), tree_a);
  EXPECT_EQ(project.state().trees.at(tree_a).stems.size(), 3u);
  EXPECT_EQ(project.state().edit_log.back().before, tree_label(tree_a) + ", " + tree_label(tree_b));
  project.execute(apply_alignment(test::straight_alignment(project.state()), {}));  // which says that both stand where they stood
  EXPECT_EQ(project.state().tree_of(a), project.state().tree_of(stem_of(project, 0, 4)));
  EXPECT_EQ(project.state().tree_of(b), project.state().tree_of(stem_of(project, 0, 3)));
}

TEST(SwapStems, RefusesStemsOfTwoSurveysWithASentence) {
  const Project project = aligned_project();
  EXPECT_EQ(why_not_swap(project.state(), stem_of(project, 0, 3), stem_of(project, 1, 4)), "Only two stems of one survey can change places");
  EXPECT_EQ(why_not_swap(project.state(), stem_of(project, 1, 3), stem_of(project, 1, 4)), "");
  ProjectState state = project.state();
  EXPECT_THROW(swap_stems(stem_of(project, 0, 3), stem_of(project, 1, 4), stamp)->apply(state), std::logic_error);
  EXPECT_EQ(state, project.state());
}

TEST(SplitTree, TheLaterSightingsBecomeATreeOfTheirOwn) {
  Project project = aligned_project();
  const TreeId tree = project.state().tree_of(stem_of(project, 0, 3));
  EXPECT_NE(why_not_split(project.state(), stem_of(project, 0, 3)), "");
  project.execute(split_tree(stem_of(project, 1, 3), stamp));
  EXPECT_EQ(project.state().trees.at(tree).stems, std::vector<StemRef>{stem_of(project, 0, 3)});
  const TreeId other = project.state().tree_of(stem_of(project, 1, 3));
  EXPECT_EQ(project.state().tree_of(stem_of(project, 2, 3)), other);
  project.execute(apply_alignment(test::straight_alignment(project.state()), {}));
  EXPECT_NE(project.state().tree_of(stem_of(project, 0, 3)), project.state().tree_of(stem_of(project, 1, 3)));
}

TEST(MergeTrees, JoinsTreesSeenInDifferentSurveysOnly) {
  Project project = aligned_project();
  const TreeId tree = project.state().tree_of(stem_of(project, 0, 3)), next = project.state().tree_of(stem_of(project, 0, 4));
  EXPECT_EQ(why_not_merge(project.state(), tree, next), "Both were seen in 2013: a tree has one stem per survey");
  project.execute(split_tree(stem_of(project, 1, 3), stamp));
  const TreeId other = project.state().tree_of(stem_of(project, 1, 3));
  project.execute(merge_trees(other, tree, stamp));
  EXPECT_EQ(project.state().trees.at(tree).stems.size(), 3u);
  EXPECT_FALSE(project.state().trees.contains(other));
}

TEST(GroupCommand, RollsBackWhenAPartThrows) {
  Project project = aligned_project();
  const ProjectState before = project.state();
  std::vector<CommandPtr> parts;
  parts.push_back(unlink_stem(stem_of(project, 1, 3), stamp));
  parts.push_back(link_stems(stem_of(project, 0, 3), stem_of(project, 0, 4), stamp));  // two stems of one inventory
  EXPECT_THROW(project.execute(group("Impossible", std::move(parts))), std::logic_error);
  EXPECT_EQ(project.state(), before);
}

TEST(Project, UndoesAndRedoesEverythingAndKnowsWhenItIsSaved) {
  Project project = aligned_project();
  const ProjectState start = project.state();
  project.mark_saved();
  project.execute(unlink_stem(stem_of(project, 1, 3), stamp));
  project.execute(set_title("x"));
  const ProjectState end = project.state();
  EXPECT_TRUE(project.is_dirty());
  project.undo();
  project.undo();
  EXPECT_EQ(project.state(), start);
  EXPECT_FALSE(project.is_dirty());
  project.redo();
  project.redo();
  EXPECT_EQ(project.state(), end);
  project.undo();
  project.undo();
  project.execute(set_title("another way"));  // the saved entry stays reachable: it is where we branched off
  project.undo();
  EXPECT_FALSE(project.is_dirty());
}

TEST(RejectMatch, SplitsTheTreeByDateAndKeepsTheLaterSightingsTogether) {
  Project project = aligned_project();
  project.execute(reject_match(stem_of(project, 0, 3), stem_of(project, 1, 3), stamp));
  const ProjectState& state = project.state();
  EXPECT_NE(state.tree_of(stem_of(project, 0, 3)), state.tree_of(stem_of(project, 1, 3)));
  EXPECT_EQ(state.tree_of(stem_of(project, 1, 3)), state.tree_of(stem_of(project, 2, 3)));
}

TEST(ReplaceInventory, KeepsNameAndDateAndForgetsWhatWasSaidOfItsStems) {
  Project project = test::aligned_project();
  const ProjectState before = project.state();
  const InventoryId id = before.inventories[1]->id;
  project.execute(replace_inventory(remade(project, 1, 17)));
  const Inventory& now = *project.state().find(id);
  EXPECT_EQ(now.stems.size(), 17u);
  EXPECT_EQ(now.name, before.inventories[1]->name);
  EXPECT_EQ(now.date, before.inventories[1]->date);
  for (const auto& [pair, match] : project.state().matches) EXPECT_TRUE(pair.first.inventory != id && pair.second.inventory != id);
  EXPECT_EQ(project.state().tree_of(stem_of(project, 0, 3)), before.tree_of(stem_of(project, 0, 3)));
}

TEST(ApplyAlignment, KeepsTreeIdsAndWhatAPersonDecided) {
  Project project = aligned_project();
  const TreeId untouched = project.state().tree_of(stem_of(project, 0, 7));
  project.execute(reject_match(stem_of(project, 0, 3), stem_of(project, 1, 3), stamp));
  project.execute(link_stems(stem_of(project, 0, 5), stem_of(project, 1, 6), stamp));
  project.execute(apply_alignment(test::straight_alignment(project.state()), {}));
  const ProjectState& state = project.state();
  EXPECT_EQ(state.tree_of(stem_of(project, 0, 7)), untouched);
  EXPECT_NE(state.tree_of(stem_of(project, 0, 3)), state.tree_of(stem_of(project, 1, 3)));
  EXPECT_EQ(state.tree_of(stem_of(project, 0, 5)), state.tree_of(stem_of(project, 1, 6)));
}

TEST(ApplyAlignment, KeepsTheIdsOfExistingTreesWhenASurveyIsAddedAndRemovedAgain) {
  Project project = aligned_project();
  const ProjectState before = project.state();
  project.execute(add_inventory(test::grid_inventory("2028", date_from_civil(2028, 7, 1), 20, 0.04)));
  project.execute(apply_alignment(test::straight_alignment(project.state()), {}));
  for (const auto& [id, tree] : before.trees) {
    const TreeRecord& now = project.state().trees.at(id);
    EXPECT_EQ(now.stems.size(), tree.stems.size() + 1);
  }
  project.execute(remove_inventory(project.state().inventories.back()->id));
  EXPECT_EQ(project.state().trees, before.trees);
  EXPECT_EQ(project.state().next_tree, before.next_tree);
}

/// Three surveys of one stand, turned and shifted against each other and placed on the earth; some decisions.
Project placed_project() {
  Project project = aligned_project();
  SurveyAlignment result = test::straight_alignment(project.state());
  result.inventories[1].reference_from_inventory = RigidTransform::planar(12.0, -7.0, 0.8);
  result.inventories[2].reference_from_inventory = {rotation_from({0.01, -0.02, -2.1}), {3.0, 40.0, 1.5}};
  result.inventories[2].second_best_pose = RigidTransform::planar(1.0, 2.0, 0.1);
  project.execute(apply_alignment(result, {}));
  project.execute(set_georeference(anchor));
  project.execute(set_fate(project.state().tree_of(stem_of(project, 0, 3)), Fate::dead, stamp));
  project.execute(set_tree_note(project.state().tree_of(stem_of(project, 0, 5)), "fork", stamp));
  project.execute(reject_match(stem_of(project, 0, 7), stem_of(project, 1, 7), stamp));
  return project;
}

void expect_same_places(const ProjectState& before, const ProjectState& after) {
  for (const auto& inventory : after.inventories) {
    for (std::size_t i = 0; i < inventory->stems.size(); ++i) {
      const StemRef stem{inventory->id, static_cast<std::int64_t>(i)};
      const Geodetic was = geodetic_from_reference(before.georeference, before.stem_in_reference_m(stem));
      const Geodetic is = geodetic_from_reference(after.georeference, after.stem_in_reference_m(stem));
      EXPECT_NEAR(is.latitude_deg, was.latitude_deg, 1e-11);
      EXPECT_NEAR(is.longitude_deg, was.longitude_deg, 1e-11);
      EXPECT_NEAR(is.height_m, was.height_m, 1e-5);
    }
  }
}

TEST(ChangeReference, LeavesEveryStemWhereItIsOnTheEarthAndEveryDecision) {
  Project project = placed_project();
  const ProjectState before = project.state();
  project.execute(set_reference(before.inventories[2]->id));
  const ProjectState& after = project.state();
  EXPECT_EQ(after.reference, before.inventories[2]->id);
  expect_same_places(before, after);
  EXPECT_EQ(after.trees, before.trees);
  EXPECT_EQ(after.matches, before.matches);
  EXPECT_EQ(after.edit_log, before.edit_log);
  EXPECT_EQ(after.alignments.at(before.reference).status, AlignmentStatus::aligned);
  project.execute(set_reference(before.reference));  // and back
  expect_same_places(before, project.state());
  project.undo();
  project.undo();
  EXPECT_EQ(project.state(), before);
}

TEST(ChangeReference, HappensWhenTheReferenceIsRemoved) {
  Project project = placed_project();
  const ProjectState before = project.state();
  const TreeId dead = before.tree_of(stem_of(project, 0, 3));
  project.execute(remove_inventory(before.reference));
  EXPECT_TRUE(project.state().is_placed(before.inventories[1]->id));
  EXPECT_TRUE(project.state().is_placed(before.inventories[2]->id));
  expect_same_places(before, project.state());
  EXPECT_EQ(project.state().trees.at(dead).fate_by_hand, Fate::dead);
}

TEST(ChangeReference, TakesAwayAGeoreferenceThatOnlyTheOldFrameHas) {
  Project project = placed_project();
  Georeference crs;
  crs.kind = GeoreferenceKind::crs;
  crs.epsg = 32632;
  project.execute(set_georeference(crs));
  project.execute(set_reference(project.state().inventories[1]->id));
  EXPECT_EQ(project.state().georeference.kind, GeoreferenceKind::none);
  project.undo();
  EXPECT_EQ(project.state().georeference, crs);
}

TEST(SwapStems, BindsBothTreesWholeSoThatALaterRunKeepsThem) {
  Project project = aligned_project();
  const StemRef a = stem_of(project, 1, 3), b = stem_of(project, 1, 4);
  project.execute(swap_stems(a, b, stamp));
  for (const auto& [first, middle, last] : {std::tuple{3, b, 3}, {4, a, 4}}) {
    EXPECT_EQ(project.state().matches.at(ordered(stem_of(project, 0, first), middle)).state, MatchState::linked);
    EXPECT_EQ(project.state().matches.at(ordered(middle, stem_of(project, 2, last))).state, MatchState::linked);
  }
}

TEST(RemoveInventory, ForgetsThePositionsThatWereGivenForItOrInItsFrame) {
  Project project = aligned_project();
  const auto id = [&](std::size_t i) { return project.state().inventories[i]->id; };
  const std::string reference = std::to_string(project.state().reference.value);
  const InventoryId last = id(2), middle = id(1);
  project.execute(set_setting(rough_pose_key(last), reference + " 1 2 0.1 3 0.1 0 0 1"));
  project.execute(set_setting(rough_pose_key(middle), std::to_string(last.value) + " 1 2 0.1 3 0.1 0 0 1"));
  project.execute(remove_inventory(last));
  EXPECT_TRUE(project.state().settings.empty());  // another survey may get its number
  project.undo();
  EXPECT_EQ(project.state().settings.size(), 2u);
}

TEST(SetDate, OverrulesTheDatesOfTheRowsSoThatGrowthGoesByIt) {
  Project project;
  for (const int year : {2013, 2018}) {
    Inventory inventory = test::grid_inventory(std::to_string(year), date_from_civil(year, 7, 1), 12, year == 2018 ? 0.02 : 0.0);
    for (Stem& stem : inventory.stems) stem.date = date_from_civil(year, 7, 1);
    project.execute(add_inventory(inventory));
  }
  project.execute(apply_alignment(test::straight_alignment(project.state()), {}));
  const ProjectState before = project.state();
  const TreeId tree = before.tree_of(stem_of(project, 0, 3));
  EXPECT_NEAR(*derive_tables(before).find(tree)->growth_m_per_year, 0.02 / 5.0, 1e-5);
  project.execute(set_inventory_date(before.inventories[1]->id, date_from_civil(2015, 7, 1)));
  EXPECT_NEAR(*derive_tables(project.state()).find(tree)->growth_m_per_year, 0.02 / 2.0, 2e-5);
  project.undo();
  EXPECT_EQ(project.state(), before);
}

TEST(LinkStems, BindsTheWholeTreeThatComesOfIt) {
  Project project = aligned_project();
  project.execute(unlink_stem(stem_of(project, 2, 3), stamp));
  project.execute(link_stems(stem_of(project, 1, 3), stem_of(project, 2, 3), stamp));
  for (const int survey : {0, 1}) EXPECT_EQ(project.state().matches.at(ordered(stem_of(project, survey, 3), stem_of(project, 2, 3))).state, MatchState::linked);
}

TEST(RemoveInventory, LeavesWhatStoodBeforeAndAfterTogetherInItsTree) {
  Project project = aligned_project();
  const ProjectState before = project.state();
  project.execute(remove_inventory(before.inventories[1]->id));
  EXPECT_EQ(project.state().trees.size(), before.trees.size());
  for (const auto& [id, tree] : project.state().trees) {
    EXPECT_EQ(tree.stems.size(), 2u);
    EXPECT_EQ(id, before.tree_of(tree.stems.front()));
    EXPECT_TRUE(project.state().matches.at(ordered(tree.stems[0], tree.stems[1])).joins());
  }
}

}  // namespace
}  // namespace stemwise
