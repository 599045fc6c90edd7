#include <gtest/gtest.h>

#include "tests/app/window/window_fixture.hpp"
#include "ui/frame.hpp"

namespace stemwise {
namespace {

// What each panel is there for, by the mouse.

TEST_F(WindowTest, TheDetailsOfASurveySetItsDateMakeItTheReferenceAndTakeItOut) {
  open_surveys();
  window().resize(1600, 1400);
  window().press(ui::ActionId::step_inventories);
  const InventoryId later = state().find("2023")->id;
  ASSERT_TRUE(window().click("inventories/2023"));
  window().settle();
  EXPECT_EQ(window().value("details/name"), "2023");
  ASSERT_TRUE(window().fill("details/date", "2023-05-04"));
  window().settle();
  EXPECT_EQ(state().find(later)->date, parse_date("2023-05-04"));
  ASSERT_TRUE(window().fill("details/date", "yesterday"));
  window().settle();
  EXPECT_EQ(state().find(later)->date, parse_date("2023-05-04"));  // told, and not taken
  ASSERT_TRUE(window().fill("details/dbh_error", "1.5"));
  window().settle();
  EXPECT_NEAR(state().dbh_error_m.at(later), 0.015, 1e-12);
  const bool was_reference = state().reference == later;
  if (!was_reference) {
    ASSERT_TRUE(window().click("details/make_reference"));
    window().settle();
  }
  EXPECT_EQ(state().reference, later);
  ASSERT_TRUE(window().click("details/remove"));
  window().settle();
  EXPECT_EQ(state().inventories.size(), 1u);
}

TEST_F(WindowTest, AFateAtTheLeftKeepsTheTablesToItsTreesAndTheEyeHidesASurvey) {
  open_surveys(300);
  align();
  window().press(ui::ActionId::step_review);
  window().settle();
  ASSERT_TRUE(window().click("fates/survivor"));
  ASSERT_TRUE(window().click("tabs/Matches"));
  window().settle();
  EXPECT_EQ(model().view.only_fate, Fate::survivor);
  ASSERT_TRUE(window().click("fates/survivor"));
  EXPECT_FALSE(model().view.only_fate);
  const int shown = model().viewport.viewport().shown_marks();
  ASSERT_TRUE(window().click("inventories/2023/eye"));
  window().settle();
  EXPECT_LT(model().viewport.viewport().shown_marks(), shown);
  ASSERT_TRUE(window().click("view/color_by"));
  window().frames(2);
  ASSERT_TRUE(window().click("view/color_by/DBH change"));
  window().settle();
  EXPECT_EQ(model().view.color_by, ui::ColorBy::growth);
}

TEST_F(WindowTest, MatchesAreSortedFilteredAndLeadToTheirTree) {
  open_surveys(300);
  align();
  ASSERT_TRUE(window().click("tabs/Matches"));
  window().settle();
  ASSERT_TRUE(window().click("matches/head/Distance, m"));
  window().settle();
  const std::string first = window().value("matches/row/0");
  ASSERT_TRUE(window().click("matches/head/Distance, m"));
  window().settle();
  EXPECT_NE(window().value("matches/row/0"), first);
  const std::string label = window().value("matches/row/2");
  ASSERT_TRUE(window().fill("matches/filter", label));
  window().settle();
  EXPECT_EQ(window().value("matches/row/0"), label);
  ASSERT_TRUE(window().click("matches/row/0"));
  window().settle();
  EXPECT_EQ(tree_label(model().view.selected_tree), label);
}

TEST_F(WindowTest, TheHistoryGoesToAnyChangeAndTheEditLogIsFiltered) {
  open_surveys();
  align();
  const TreeId tree = lonely_matched_tree();
  ASSERT_TRUE(tree);
  click_in_map(tree);
  window().press(ui::ActionId::review_dead);
  window().frames(3);
  window().press(ui::ActionId::review_clear_fate);
  window().press(ui::ActionId::review_dead);
  window().settle();
  const ProjectState after = state();
  const std::size_t now = model().document.project().history_position();
  window().press(ui::ActionId::edit_history);
  window().frames(3);
  ASSERT_TRUE(window().click("history/" + std::to_string(now - 3)));
  window().settle();
  EXPECT_FALSE(state().trees.at(tree).fate_by_hand);
  ASSERT_TRUE(window().click("history/" + std::to_string(now)));
  window().settle();
  EXPECT_EQ(state(), after);
  window().press({ui::Key::escape});
  window().frames(3);
  EXPECT_EQ(model().view.dialog, ui::Dialog::none);
  ASSERT_TRUE(window().click("tabs/Edit log"));
  window().settle();
  EXPECT_TRUE(window().has("log/row/1"));
  ASSERT_TRUE(window().fill("log/filter", "no such thing"));
  window().settle();
  EXPECT_FALSE(window().has("log/row/0"));
}

TEST_F(WindowTest, ANoteIsKeptWithTheTreeAndThePaletteFindsATree) {
  open_surveys();
  align();
  const TreeId tree = lonely_matched_tree();
  ASSERT_TRUE(tree);
  click_in_map(tree);
  window().resize(1600, 1200);
  ASSERT_TRUE(window().fill("review/note", "leans to the road"));
  window().settle();
  EXPECT_EQ(state().trees.at(tree).note, "leans to the road");
  EXPECT_FALSE(window().value("review/confidence").empty());
  model().view.selected_tree = {};
  window().press(ui::ActionId::help_palette);
  window().frames(3);
  window().type(tree_label(tree));
  window().press({ui::Key::enter});
  window().settle();
  EXPECT_EQ(model().view.selected_tree, tree);
}

TEST_F(WindowTest, TablesOfAnEarlierRevisionAreNeverDrawnWithALaterProject) {
  open_surveys();
  align();
  ASSERT_TRUE(window().click("tabs/Growth"));
  window().settle();
  model().document.undo();  // no survey has a place any more, but the tables do not know it yet
  ASSERT_FALSE(model().document.is_derived());
  model().view.color_by = ui::ColorBy::inventory;
  model().view.chart = ui::Chart::residual_rose;
  EXPECT_NO_THROW(window().frame());
  window().settle();
  EXPECT_TRUE(model().document.is_derived());
}

TEST_F(WindowTest, LayersAndThemeAreSwitchedAndRemembered) {
  open_surveys();
  align();
  ASSERT_TRUE(window().click("viewport/layers"));
  window().frames(2);
  ASSERT_TRUE(window().click("layers/labels"));
  window().press({ui::Key::escape});
  window().press(ui::ActionId::view_theme);
  window().press(ui::ActionId::view_reduce_motion);
  window().frames(2);
  window().desk().remember(1600, 1000, false);
  window_.reset();
  auto again = HeadlessWindow::create({.desk = {.paths = {}, .config_folder = (folder_ / "config").string()}});
  ASSERT_TRUE(again);
  window_ = std::move(*again);
  EXPECT_TRUE(model().view.layers.labels);
  EXPECT_TRUE(model().view.reduce_motion);
  EXPECT_EQ(model().view.theme, ui::ThemeName::dark);
}

}  // namespace
}  // namespace stemwise
