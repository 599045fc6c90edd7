#include <gtest/gtest.h>

#include <set>

#include "app/window/requests.hpp"
#include "app/window/review_walk.hpp"
#include "tests/app/window/window_fixture.hpp"
#include "ui/frame.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

QueueRow row(std::int64_t tree, double doubt, bool decided = false) { return {TreeId{tree}, 0, doubt, "", decided}; }

TEST(ReviewWalk, GoesOnAfterARowThatWasDecidedAndMovedToTheEnd) {
  ReviewWalk walk;
  EXPECT_EQ(walk.next({row(1, 0.9), row(2, 0.8), row(3, 0.7)}), 0u);
  walk.stand_on(row(2, 0.8), true);
  walk.decided(TreeId{2});
  EXPECT_EQ(walk.next({row(1, 0.9), row(3, 0.7), row(2, 0.8, true)}), 1u);
}

TEST(ReviewWalk, GoesOnFromWhereItWasWhenTheTreeEntersAgainWithAnotherDoubt) {
  ReviewWalk walk;
  walk.stand_on(row(2, 0.8), true);
  walk.decided(TreeId{2});
  EXPECT_EQ(walk.next({row(1, 0.9), row(3, 0.7), row(4, 0.6), row(2, 0.3)}), 1u);
  EXPECT_EQ(walk.next({row(2, 0.95), row(1, 0.9), row(3, 0.7)}), 2u);
}

TEST(ReviewWalk, SeesAmongEqualDoubtsEachRowOnceAndThenStartsFromTheTop) {
  const std::vector<QueueRow> queue{row(1, 0.3), row(2, 0.3), row(3, 0.3)};
  ReviewWalk walk;
  std::vector<std::int64_t> seen;
  for (int i = 0; i < 4; ++i) {
    const auto at = walk.next(queue);
    ASSERT_TRUE(at);
    walk.stand_on(queue[*at], false);
    seen.push_back(queue[*at].tree.value);
  }
  EXPECT_EQ(seen, (std::vector<std::int64_t>{1, 2, 3, 1}));
}

TEST(ReviewWalk, SkipsWhatItHasSeenWhenDoubtsDriftALittle) {
  ReviewWalk walk;
  walk.stand_on(row(1, 0.500), false);
  walk.stand_on(row(2, 0.499), false);
  EXPECT_EQ(walk.next({row(2, 0.498), row(1, 0.497), row(3, 0.4)}), 2u);
}

TEST(ReviewWalk, GoesBackToTheRowBeforeAndKnowsWhenNothingIsLeft) {
  ReviewWalk walk;
  walk.stand_on(row(2, 0.8), false);
  EXPECT_EQ(walk.previous({row(1, 0.9), row(2, 0.8), row(3, 0.7)}), 0u);
  EXPECT_FALSE(walk.next({row(1, 0.9, true)}));
  EXPECT_FALSE(walk.previous({}));
}

TEST_F(WindowTest, TenRowsDecidedByKeysOnlyComeInTheOrderOfTheirDoubt) {
  open_surveys(400);
  align();
  const std::size_t at_first = model().document.derived().tables.queue.size();
  ASSERT_GE(at_first, 12u);
  double last_doubt = 2.0;
  // What a row asks: whether two stems are one tree, or what became of the tree.
  const auto question = [&](const QueueRow& q) { return std::pair(q.tree, q.match ? model().document.derived().tables.matches[*q.match].b : StemRef{}); };
  std::set<std::pair<TreeId, StemRef>> seen;
  const ui::ActionId decisions[] = {ui::ActionId::review_accept, ui::ActionId::review_reject, ui::ActionId::review_unlink};
  int rejected = 0, matches = 0;
  for (int i = 0; i < 10; ++i) {
    window().press(ui::ActionId::review_next);
    window().settle();
    const TreeId tree = model().view.selected_tree;
    const QueueRow* doubt = model().document.derived().doubt(tree);
    ASSERT_NE(doubt, nullptr) << i;
    EXPECT_FALSE(doubt->decided) << i;
    EXPECT_TRUE(seen.insert(question(*doubt)).second) << tree_label(tree) << " came twice";
    EXPECT_LE(doubt->doubt, last_doubt) << i;
    // Nothing in between was left out.
    for (const QueueRow& other : model().document.derived().tables.queue) {
      if (other.decided || seen.contains(question(other))) continue;
      EXPECT_FALSE(other.doubt > doubt->doubt && other.doubt < last_doubt) << tree_label(other.tree);
    }
    last_doubt = doubt->doubt;
    const ui::ActionId decision = doubt->match ? decisions[++matches % 3] : ui::ActionId::review_accept;
    rejected += decision == ui::ActionId::review_reject ? 1 : 0;
    const std::size_t entries = state().edit_log.size();
    window().press(decision);
    window().settle();
    EXPECT_EQ(state().edit_log.size(), entries + 1) << i;
  }
  EXPECT_GE(rejected, 1);
}

TEST_F(WindowTest, TheKeysActOnThePairWhoseDoubtIsShown) {
  open_surveys(400, {2012, 2017, 2022});
  align();
  const Tables& tables = model().document.derived().tables;
  // A tree seen three times whose doubt is about its first two sightings: not what would be taken without looking.
  const auto found = std::find_if(tables.queue.begin(), tables.queue.end(), [&](const QueueRow& q) {
    return q.match && !q.decided && state().trees.at(q.tree).stems.size() == 3 && tables.matches[*q.match].b.inventory != tables.inventories.back();
  });
  ASSERT_NE(found, tables.queue.end());
  const TreeId tree = found->tree;
  const MatchRow pair = tables.matches[*found->match];
  select_tree(model(), tree, false);  // as a click on its row does
  model().view.step = ui::Step::review;
  window().settle();
  EXPECT_EQ(model().view.selected_stem, pair.b);
  EXPECT_EQ(window().value("review/pair"), ui::stem_label(state(), pair.a) + " and " + ui::stem_label(state(), pair.b));

  window().press(ui::ActionId::review_unlink);
  window().settle();
  EXPECT_NE(state().tree_of(pair.b), tree);
  EXPECT_EQ(state().tree_of(pair.a), tree);
  window().press(ui::ActionId::edit_undo);
  window().settle();

  select_tree(model(), tree, false);
  window().frames(2);
  window().press(ui::ActionId::review_reject);
  window().settle();
  const auto match = state().matches.find(ordered(pair.a, pair.b));
  ASSERT_NE(match, state().matches.end());
  EXPECT_EQ(match->second.state, MatchState::rejected);
}

TEST_F(WindowTest, TheFatesAreOfTheLastTwoSurveysAndEarlierTreesAreCountedApart) {
  open_surveys(300, {2012, 2017, 2022});
  align();
  const ui::Derived& derived = model().document.derived();
  EXPECT_EQ(window().value("fates/head"), "2017 to 2022");
  int counted = derived.seen_before_only, only_first = 0;
  for (const int count : derived.last_step_fates) counted += count;
  for (const TreeRow& tree : derived.tables.trees) only_first += tree.last_seen == derived.tables.inventories.front() ? 1 : 0;
  EXPECT_EQ(counted, static_cast<int>(derived.tables.trees.size()));
  EXPECT_EQ(derived.seen_before_only, only_first);
  EXPECT_GT(only_first, 0);
  for (const auto& [id, shared] : derived.in_overlap) {
    const std::size_t all = state().find(id)->stems.size();
    EXPECT_GT(shared.matched, 0);
    EXPECT_LE(shared.matched, shared.stems);
    EXPECT_LE(static_cast<std::size_t>(shared.stems), all);
  }
  const ui::InOverlap last = derived.in_overlap.at(derived.tables.inventories.back());
  model().view.selected_inventory = derived.tables.inventories.back();
  window().frames(2);
  if (state().reference != derived.tables.inventories.back()) {
    EXPECT_EQ(window().value("alignment/overlap"), ui::percent_text(static_cast<double>(last.matched) / last.stems, 1));
  }
}

TEST_F(WindowTest, RightAfterUnlinkingTheStemThatStandsThereIsAnAlternative) {
  open_surveys();
  align();
  const TreeId tree = lonely_matched_tree();
  ASSERT_TRUE(tree);
  click_in_map(tree);
  const std::vector<StemRef> stems = state().trees.at(tree).stems;
  ASSERT_EQ(stems.size(), 2u);
  window().press(ui::ActionId::review_unlink);
  window().settle();
  const StemRef other = model().view.selected_stem == stems[0] ? stems[1] : stems[0];
  ASSERT_TRUE(window().click("review/alternative/" + ui::stem_label(state(), other)));
  window().settle();
  EXPECT_EQ(state().tree_of(stems[0]), state().tree_of(stems[1]));
}

TEST_F(WindowTest, EveryDecisionMovesTheProgressOn) {
  open_surveys(400);
  align();
  const auto decided = [&] { return model().document.derived().decided; };
  ASSERT_EQ(decided(), 0);
  const ui::ActionId decisions[] = {ui::ActionId::review_reject, ui::ActionId::review_accept, ui::ActionId::review_removed};
  for (int i = 0; i < 6; ++i) {
    window().press(ui::ActionId::review_next);
    window().settle();
    const QueueRow* row = model().document.derived().doubt(model().view.selected_tree);
    ASSERT_NE(row, nullptr);
    window().press(row->match ? decisions[i % 2] : decisions[1 + i % 2]);
    window().settle();
    EXPECT_EQ(decided(), i + 1);
  }
  const std::string said = window().value("queue/progress");
  EXPECT_EQ(said.find("6 of "), 0u) << said;
}

TEST_F(WindowTest, AFateThatTheSightingsContradictIsGreyedOutAndSkippedInAGroup) {
  open_surveys(400);
  align();
  window().press(ui::ActionId::step_review);
  window().frames(2);
  const TreeId tree = lonely_matched_tree();
  ASSERT_TRUE(tree);
  click_in_map(tree);
  window().settle();
  for (const ui::ActionId id : {ui::ActionId::review_ingrowth, ui::ActionId::review_missed_earlier, ui::ActionId::review_removed}) window().press(id);
  window().settle();
  EXPECT_FALSE(state().trees.at(tree).fate_by_hand);
  EXPECT_FALSE(why_not_fate(state(), tree, Fate::ingrowth).empty());
  const auto gone = std::find_if(model().document.derived().tables.trees.begin(), model().document.derived().tables.trees.end(), [](const TreeRow& row) { return row.fate == Fate::missing; });
  ASSERT_NE(gone, model().document.derived().tables.trees.end());
  const TreeId missing = gone->tree;
  select_group(model(), {tree, missing});
  window().frames(2);
  window().press(ui::ActionId::review_removed);
  window().settle();
  EXPECT_EQ(state().trees.at(missing).fate_by_hand, Fate::removed);
  EXPECT_FALSE(state().trees.at(tree).fate_by_hand);
  ASSERT_FALSE(model().notices.all().empty());
  EXPECT_NE(model().notices.all().front().title.find("1 tree was left"), std::string::npos) << model().notices.all().front().title;
}

TEST_F(WindowTest, WhoWantsItIsLedToTheNextTreeByEachDecision) {
  open_surveys(400);
  align();
  window().press(ui::ActionId::review_go_on);
  window().press(ui::ActionId::review_next);
  window().settle();
  std::set<TreeId> seen;
  for (int i = 0; i < 8; ++i) {
    EXPECT_TRUE(seen.insert(model().view.selected_tree).second) << i;
    window().press(ui::ActionId::review_accept);  // no waiting for the tables
    EXPECT_EQ(state().edit_log.size(), static_cast<std::size_t>(i + 1));
  }
  window().settle();
  EXPECT_EQ(model().document.derived().decided, 8);
}

TEST_F(WindowTest, ASecondAcceptDoesNotDecideOnSomethingElseOfTheTree) {
  open_surveys(400, {2013, 2018, 2023});
  align();
  const std::vector<QueueRow>& queue = model().document.derived().tables.queue;
  const auto row = std::find_if(queue.begin(), queue.end(), [&](const QueueRow& q) {
    return !q.match && std::ranges::any_of(model().document.derived().matches_of(q.tree), [](const MatchRow* match) { return match->state == MatchState::automatic; });
  });
  ASSERT_NE(row, queue.end());  // its fate is in doubt, and it has a match that nobody doubts
  select_tree(model(), row->tree, true);
  window().press(ui::ActionId::step_review);
  window().frames(2);
  for (int i = 0; i < 3; ++i) {
    window().press(ui::ActionId::review_accept);
    window().settle();
  }
  EXPECT_EQ(state().edit_log.size(), 1u);
}

TEST_F(WindowTest, TheArrowKeysOfTheQueueSelectTheRowThatTheyReach) {
  open_surveys(400);
  align();
  window().press(ui::ActionId::step_review);
  window().settle();
  ASSERT_TRUE(window().click("queue/row/0"));
  window().frames(3);
  const TreeId first = model().view.selected_tree;
  window().press({ui::Key::down});
  window().frames(3);
  window().press({ui::Key::down});
  window().frames(3);
  EXPECT_NE(model().view.selected_tree, first);
  EXPECT_EQ(tree_label(model().view.selected_tree), window().value("queue/row/2"));
}

}  // namespace
}  // namespace stemwise
