#include "app/align_job.hpp"
#include "core/geodesy/georeference.hpp"
#include "core/project/regroup_commands.hpp"
#include "io/project_file.hpp"
#include "tests/app/run_program.hpp"
#include "tests/app/window/window_fixture.hpp"

namespace stemwise {
namespace {

using testing::ProgramRun;
using testing::run_stemwise;

/// A walk that has drifted by 3 %, and a bare list of the same forest: folder "surveys" with 2015 (frames) and 2019.csv.
void simulate_drifting_walk(const fs::path& folder) {
  const std::vector<std::string> common{"--stems", "350", "--drop", "0.2", "--position-noise-m", "0.15", "--years", "2015,2019", "--seed", "2", "-q"};
  const auto simulate = [&](const std::string& into, std::vector<std::string> more) {
    std::vector<std::string> call{"simulate", "-o", (folder / into).string()};
    call.insert(call.end(), common.begin(), common.end());
    call.insert(call.end(), more.begin(), more.end());
    const ProgramRun run = run_stemwise(call);
    ASSERT_EQ(run.code, 0) << run.err;
  };
  simulate("walk", {"--frames", "--drift", "0.03"});
  simulate("lists", {});
}

struct DriftingWalk : WindowTest {
  std::string walk() const { return (folder_ / "walk" / "2015").string(); }
  std::string list() const { return (folder_ / "lists" / "2019.csv").string(); }
};

TEST_F(DriftingWalk, IsCorrectedByTheWindowAsByTheCommandLine) {
  simulate_drifting_walk(folder_);
  const std::string project = (folder_ / "by_hand.gpkg").string();
  const ProgramRun run = run_stemwise({"align", walk(), list(), "-o", project});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE((run.out + run.err).find("the trajectory had drifted"), std::string::npos) << run.out << run.err;
  const Result<ProjectState> by_command_line = read_project(project);
  ASSERT_TRUE(by_command_line);

  window().desk().drop({walk(), list()});
  window().settle();
  const ProjectState before = state();
  ASSERT_EQ(before.inventories.size(), 2u);
  align();
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(*state().inventories[i], *by_command_line->inventories[i]);
  EXPECT_NE(*state().inventories[0], *before.inventories[0]);
  EXPECT_EQ(state().alignments, by_command_line->alignments);
  EXPECT_EQ(state().matches, by_command_line->matches);
  EXPECT_EQ(state().trees, by_command_line->trees);

  const ProjectState after = state();
  window().press(ui::ActionId::edit_undo);
  window().settle();
  EXPECT_EQ(state(), before);
  window().press(ui::ActionId::edit_redo);
  window().settle();
  EXPECT_EQ(state(), after);
}

TEST_F(DriftingWalk, KeepsItsStemsOnceAPersonSpokeOfThem) {
  simulate_drifting_walk(folder_);
  window().desk().drop({walk(), list()});
  window().settle();
  const InventoryId reference = state().reference;
  model().execute(set_tree_note(state().tree_of({reference, 3}), "the old oak", {"me", "2026-11-22T08:00:00Z", ""}));
  const ProjectState before = state();
  align();
  EXPECT_EQ(state().find(reference)->stems, before.find(reference)->stems);
}

TEST_F(DriftingWalk, ReopenedItIsAlignedByTheTreesThatWereCorrected) {
  simulate_drifting_walk(folder_);
  const std::string project = (folder_ / "saved.gpkg").string();
  ASSERT_EQ(run_stemwise({"align", walk(), list(), "-o", project, "-q"}).code, 0);
  const Result<ProjectState> saved = read_project(project);
  ASSERT_TRUE(saved);
  const AlignOutcome again = align_project(*saved, {}, {}, {});
  EXPECT_TRUE(again.corrected.empty());
  ASSERT_FALSE(again.alignment.notes.empty());
  EXPECT_NE(again.alignment.notes.front().find("a corrected trajectory, or other frames"), std::string::npos) << again.alignment.notes.front();
}

TEST_F(DriftingWalk, ReopenedAFaithfulWalkIsAlignedByItsFramesAgain) {
  const ProgramRun made = run_stemwise({"simulate", "-o", (folder_ / "walk").string(), "--frames", "--stems", "200", "--years", "2015,2019", "--tilt-deg", "3", "-q"});
  ASSERT_EQ(made.code, 0) << made.err;
  const std::string project = (folder_ / "saved.gpkg").string();
  ASSERT_EQ(run_stemwise({"align", walk(), (folder_ / "walk" / "2019").string(), "-o", project, "-q"}).code, 0);
  const Result<ProjectState> saved = read_project(project);
  ASSERT_TRUE(saved);
  const AlignOutcome again = align_project(*saved, {}, {}, {});
  for (const std::string& note : again.alignment.notes) EXPECT_EQ(note.find("by its trees alone"), std::string::npos) << note;
  std::map<InventoryId, InventoryAlignment> poses;
  for (const InventoryAlignment& a : again.alignment.inventories) poses[a.inventory] = a;
  EXPECT_EQ(poses, saved->alignments);
}

TEST_F(WindowTest, AnotherReferenceKeepsPlacesDecisionsAndTreesAlsoWhenAllIsAlignedAgain) {
  open_surveys(220);
  align();
  Georeference place;
  place.kind = GeoreferenceKind::anchor;
  place.origin = {48.5, 8.25, 500.0};
  place.azimuth_deg = 12.5;
  model().execute(set_georeference(place));
  window().settle();
  const TreeId tree = model().document.derived().tables.trees[10].tree;
  model().execute(set_tree_note(tree, "fork", {"Ada", "2026-11-22T10:00:00Z", ""}));
  model().execute(set_fate(tree, Fate::dead, {"Ada", "2026-11-22T10:00:00Z", ""}));
  window().settle();
  const auto on_earth = [&] { return geodetic_from_reference(state().georeference, model().document.derived().tables.find(tree)->position_m); };
  const Geodetic before = on_earth();
  const ProjectState as_it_was = state();
  InventoryId other;
  for (const auto& inventory : state().inventories)
    if (inventory->id != state().reference) other = inventory->id;
  window().press(ui::ActionId::step_inventories);
  model().view.selected_inventory = other;
  window().frames(2);
  window().press(ui::ActionId::edit_make_reference);
  window().settle();
  ASSERT_EQ(state().reference, other);
  EXPECT_NEAR(on_earth().latitude_deg, before.latitude_deg, 1e-6);  // some cm: the tree's middle may be taken elsewhere
  EXPECT_NEAR(on_earth().longitude_deg, before.longitude_deg, 1e-6);
  align();
  EXPECT_EQ(state().trees.at(tree).note, "fork");
  EXPECT_EQ(state().trees.at(tree).fate_by_hand, Fate::dead);
  EXPECT_NEAR(on_earth().latitude_deg, before.latitude_deg, 5e-6);
  std::size_t same = 0;
  for (const auto& [id, record] : as_it_was.trees) {
    const auto now = state().trees.find(id);
    same += now != state().trees.end() && now->second.stems == record.stems ? 1 : 0;
  }
  EXPECT_GE(same, as_it_was.trees.size() * 97 / 100);
}

TEST_F(WindowTest, ASwapOfDistantStemsIsKeptByALaterRunAndMovesNoSurvey) {
  open_surveys(400, {2015, 2019, 2023});
  align();
  const Tables& tables = model().document.derived().tables;
  const auto seen_by_all = [](const TreeRow& tree) { return tree.times_seen == 3; };
  const auto first = std::find_if(tables.trees.begin(), tables.trees.end(), seen_by_all);
  const auto second = std::find_if(first + 1, tables.trees.end(), [&](const TreeRow& tree) {
    const double apart_m = (tree.position_m - first->position_m).head<2>().norm();
    return seen_by_all(tree) && apart_m > 3.0 && apart_m < 12.0;
  });
  ASSERT_NE(second, tables.trees.end());
  const TreeId one = first->tree, other = second->tree;
  const std::vector<InventoryId> order = state().by_date();
  const auto stem_in = [&](TreeId tree, InventoryId inventory) {
    for (const StemRef& stem : state().trees.at(tree).stems)
      if (stem.inventory == inventory) return stem;
    return StemRef{};
  };
  const StemRef a = stem_in(one, order[1]), b = stem_in(other, order[1]);
  model().execute(swap_stems(a, b, {"Ada", "2026-11-22T10:00:00Z", ""}));
  window().settle();
  const std::size_t matches = state().matches.size();
  align();
  for (const InventoryId id : order) EXPECT_TRUE(state().is_placed(id)) << state().alignments.at(id).reason;
  EXPECT_EQ(state().tree_of(a), other);
  EXPECT_EQ(state().tree_of(b), one);
  EXPECT_GE(state().matches.size(), matches * 95 / 100);
}

}  // namespace
}  // namespace stemwise
