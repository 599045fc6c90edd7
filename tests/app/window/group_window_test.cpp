#include <gtest/gtest.h>

#include <set>

#include "app/window/click_effect.hpp"
#include "app/window/requests.hpp"
#include "tests/app/window/window_fixture.hpp"
#include "ui/frame.hpp"

namespace stemwise {
namespace {

class GroupTest : public WindowTest {
 protected:
  void review(int stems = 180, const std::vector<int>& years = {2018, 2023}) {
    open_surveys(stems, years);
    align();
    window().press(ui::ActionId::step_review);
    window().settle();
  }
  ui::Rect map() { return window().desk().registry().find("viewport")->rect; }
  void drag_in_map(float x0, float y0, float x1, float y1) {
    const ui::Rect rect = map();
    window().drag(rect.x + x0, rect.y + y0, rect.x + x1, rect.y + y1);
    window().frames(2);
  }
  void hover(TreeId tree) {
    const auto at = model().viewport.viewport().pixels_of(tree);
    ASSERT_TRUE(at);
    window().move_to(map().x + static_cast<float>(at->x()), map().y + static_cast<float>(at->y()));
    window().frames(2);
  }
  /// Matched trees that stand alone in the picture, so that a click can mean nothing else.
  std::vector<TreeId> clear_trees(std::size_t count) {
    std::vector<TreeId> found;
    const Tables& tables = model().document.derived().tables;
    for (const TreeRow& tree : tables.trees) {
      const auto at = model().viewport.viewport().pixels_of(tree.tree);
      if (tree.times_seen != static_cast<int>(tables.inventories.size()) || !at || at->x() < 300 || at->x() > 820 || at->y() < 100 || at->y() > 500) continue;
      const bool alone = std::none_of(tables.trees.begin(), tables.trees.end(), [&](const TreeRow& other) {
        return other.tree != tree.tree && (other.position_m - tree.position_m).head<2>().norm() < 2.0;
      });
      if (alone) found.push_back(tree.tree);
      if (found.size() == count) break;
    }
    return found;
  }
};

TEST_F(GroupTest, ARectangleSelectsTreesWhichAreAcceptedTogetherAndUndoneAtOnce) {
  review();
  const ProjectState before = state();
  window().hold_shift(true);
  drag_in_map(250, 90, 700, 420);
  window().hold_shift(false);
  window().settle();
  const std::vector<TreeId> group = model().view.group;
  ASSERT_GE(group.size(), 5u);
  EXPECT_EQ(group, model().viewport.viewport().trees_in_rectangle(250, 90, 700, 420));
  EXPECT_EQ(window().value("group/count"), std::to_string(group.size()) + " trees selected");
  EXPECT_FALSE(window().has("review/accept"));
  window().press(ui::ActionId::review_accept);
  window().settle();
  int accepted = 0;
  for (const TreeId tree : group) {
    for (const MatchRow* match : model().document.derived().matches_of(tree)) {
      EXPECT_NE(match->state, MatchState::automatic);
      accepted += match->state == MatchState::accepted ? 1 : 0;
    }
  }
  EXPECT_GE(accepted, 4);
  window().press(ui::ActionId::edit_undo);
  EXPECT_EQ(state(), before);
  window().press({ui::Key::escape});
  EXPECT_TRUE(model().view.group.empty());
}

TEST_F(GroupTest, TheRectangleToolDoesTheSameWithoutShiftAndFatesMeanAll) {
  review();
  window().press(ui::ActionId::tool_rectangle);
  drag_in_map(300, 120, 600, 400);
  window().settle();
  const std::vector<TreeId> group = model().view.group;
  ASSERT_GE(group.size(), 2u);
  EXPECT_EQ(model().view.tool, ui::Tool::select);
  window().press(ui::ActionId::review_dead);
  window().settle();
  for (const TreeId tree : group) EXPECT_EQ(state().trees.at(tree).fate_by_hand, Fate::dead);
}

TEST_F(GroupTest, CtrlAndAClickAddAndTakeAwayATree) {
  review();
  const std::vector<TreeId> trees = clear_trees(2);
  ASSERT_EQ(trees.size(), 2u);
  click_in_map(trees[0]);
  window().hold_ctrl(true);
  click_in_map(trees[1]);
  EXPECT_EQ(model().view.group.size(), 2u);
  click_in_map(trees[1]);
  window().hold_ctrl(false);
  EXPECT_TRUE(model().view.group.empty());
  EXPECT_EQ(model().view.selected_tree, trees[0]);
}

TEST_F(GroupTest, TwoStemsAreSwappedByTheMouseAndWhatAClickWouldDoIsShownBefore) {
  review();
  const std::vector<TreeId> trees = clear_trees(2);
  ASSERT_EQ(trees.size(), 2u);
  const ProjectState before = state();
  click_in_map(trees[0]);
  const StemRef a = state().trees.at(trees[0]).stems[1], b = state().trees.at(trees[1]).stems[1];
  model().view.selected_stem = a;
  window().press(ui::ActionId::review_swap);
  ASSERT_EQ(model().view.tool, ui::Tool::swap);
  hover(trees[1]);
  ASSERT_TRUE(model().status.hover);
  EXPECT_EQ(model().status.hover->detail, "Swap " + ui::stem_label(state(), a) + " and " + ui::stem_label(state(), b));
  EXPECT_TRUE(model().status.click_line);
  EXPECT_EQ(state(), before);
  click_in_map(trees[1]);
  window().settle();
  EXPECT_EQ(state().tree_of(a), trees[1]);
  EXPECT_EQ(state().tree_of(b), trees[0]);
  EXPECT_EQ(model().view.tool, ui::Tool::select);
  window().press(ui::ActionId::edit_undo);
  EXPECT_EQ(state(), before);
}

TEST_F(GroupTest, ATreeIsSplitByItsKeyAndMergedAgainByTheMouse) {
  review(220, {2012, 2017, 2022});
  const std::vector<TreeId> trees = clear_trees(1);
  ASSERT_EQ(trees.size(), 1u);
  click_in_map(trees[0]);
  const std::vector<StemRef> stems = state().trees.at(trees[0]).stems;
  ASSERT_EQ(stems.size(), 3u);
  model().view.selected_stem = stems[1];
  window().press(ui::ActionId::review_split);
  window().settle();
  EXPECT_EQ(state().trees.at(trees[0]).stems, std::vector<StemRef>{stems[0]});
  EXPECT_EQ(state().tree_of(stems[1]), state().tree_of(stems[2]));
  const TreeId later = state().tree_of(stems[1]);
  select_tree(model(), later, false);
  window().frames(2);
  window().press(ui::ActionId::review_merge);
  model().view.hidden = {stems[1].inventory, stems[2].inventory};  // the other part lies beneath
  window().settle();
  const auto at = model().viewport.viewport().pixels_of(stems[0]);
  ASSERT_TRUE(at);
  window().click_at(map().x + static_cast<float>(at->x()), map().y + static_cast<float>(at->y()));
  window().settle();
  EXPECT_EQ(state().trees.at(trees[0]).stems, stems);
  EXPECT_FALSE(state().trees.contains(later));
}

TEST_F(GroupTest, NextKeepsToTheFiltersOfTheQueue) {
  review(400);
  const std::vector<QueueRow> queue = model().document.derived().tables.queue;
  std::map<DoubtKind, int> kinds;
  for (const QueueRow& row : queue) ++kinds[kind_of(row)];
  ASSERT_GE(kinds.size(), 2u);
  const DoubtKind rare = std::min_element(kinds.begin(), kinds.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;
  ASSERT_TRUE(window().click("queue/reason"));
  window().frames(2);
  ASSERT_TRUE(window().click(std::string("queue/reason/") + doubt_label(rare)));
  window().frames(2);
  EXPECT_EQ(model().view.queue.kind, rare);
  std::set<TreeId> seen;
  for (int i = 0; i < kinds[rare] + 2; ++i) {
    window().press(ui::ActionId::review_next);
    const QueueRow* row = model().document.derived().doubt(model().view.selected_tree);
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(kind_of(*row), rare) << row->why;
    seen.insert(row->tree);
  }
  EXPECT_EQ(static_cast<int>(seen.size()), kinds[rare]);
  window().press(ui::ActionId::review_accept);
  window().settle();
  EXPECT_EQ(window().value("queue/progress"), "1 of " + std::to_string(kinds[rare]) + " decided here");
  window().press(ui::ActionId::review_clear_filters);
  EXPECT_FALSE(model().view.queue.kind);
}

TEST_F(GroupTest, TheQueueCanBeKeptToWhatTheMapShows) {
  review(400);
  const QueueRow first = model().document.derived().tables.queue.front();
  select_tree(model(), first.tree, false);
  window().press(ui::ActionId::view_focus);
  window().settle();
  window().press(ui::ActionId::review_region);
  window().frames(2);
  ASSERT_TRUE(model().view.queue.region);
  const ui::QueueProgress part = ui::progress_of(model().view.queue, model().view, model().document.derived());
  EXPECT_GE(part.all, 1);
  EXPECT_LT(part.all, static_cast<int>(model().document.derived().tables.queue.size()));
  window().press(ui::ActionId::review_region);
  EXPECT_FALSE(model().view.queue.region);
}

TEST_F(GroupTest, LinkingSaysWhichStemHasToMakeRoom) {
  review();
  const std::vector<TreeId> trees = clear_trees(2);
  ASSERT_EQ(trees.size(), 2u);
  const StemRef from = state().trees.at(trees[0]).stems[0], to = state().trees.at(trees[1]).stems[1];
  const ClickEffect effect = effect_of_click(state(), ui::Tool::link, from, to);
  EXPECT_TRUE(effect.possible);
  EXPECT_NE(effect.words.find("leaves " + tree_label(trees[0])), std::string::npos) << effect.words;
  EXPECT_NE(effect.words.find("leaves " + tree_label(trees[1])), std::string::npos) << effect.words;
  EXPECT_FALSE(effect_of_click(state(), ui::Tool::link, from, state().trees.at(trees[0]).stems[1]).possible);
  EXPECT_FALSE(effect_of_click(state(), ui::Tool::merge, from, to).possible);
}

TEST(DoubtKinds, EveryReasonOfTheQueueIsOfAKind) {
  EXPECT_EQ(kind_of({{}, {}, 0, "second candidate 0.31 m away", false}), DoubtKind::second_candidate);
  EXPECT_EQ(kind_of({{}, {}, 0, "shrank 4.2 cm, error 1.1 cm", false}), DoubtKind::shrank);
  EXPECT_EQ(kind_of({{}, {}, 0, "grew 31 mm per year", false}), DoubtKind::grew);
  EXPECT_EQ(kind_of({{}, {}, 0, "dead, removed or overlooked?", false}), DoubtKind::missing);
  EXPECT_EQ(kind_of({{}, {}, 0, "marked by hand", true}), DoubtKind::other);
}

}  // namespace
}  // namespace stemwise
