#include <gtest/gtest.h>

#include <set>

#include "tests/app/window/window_fixture.hpp"

namespace stemwise {
namespace {

constexpr ui::KeyChord tab{static_cast<ui::Key>(258)};
constexpr ui::KeyChord back_tab{static_cast<ui::Key>(258), false, true};
constexpr ui::KeyChord space{ui::Key::space};

class KeyboardTest : public WindowTest {
 protected:
  /// Presses Tab until the focus is on this control; every control on the way is noted.
  bool tab_to(const std::string& path, std::set<std::string>* passed = nullptr) {
    for (int i = 0; i < 400; ++i) {
      window().press(tab);
      const std::string& here = window().desk().focused();
      if (passed != nullptr) passed->insert(here);
      if (here == path) return true;
    }
    return false;
  }
};

TEST_F(KeyboardTest, TabReachesEveryPanelAndSpacePressesWhatHasTheFocus) {
  window().press(ui::ActionId::file_demo);
  window().settle();
  window().press(ui::ActionId::step_align);
  window().settle();
  std::set<std::string> passed;
  ASSERT_TRUE(tab_to("tabs/Growth", &passed));
  ASSERT_TRUE(tab_to("steps/1", &passed));  // and around
  ASSERT_TRUE(tab_to("tabs/Growth", &passed));
  for (const char* path : {"menu/Edit", "steps/2", "inventories/add", "align/run", "viewport/layers"}) EXPECT_TRUE(passed.contains(path)) << path;
  window().press(space);
  EXPECT_EQ(model().view.tab, ui::BottomTab::growth);
  EXPECT_FALSE(model().view.blink);  // Space meant the tab
  ASSERT_TRUE(tab_to("steps/4"));
  window().press(back_tab);
  EXPECT_EQ(window().desk().focused(), "steps/3");
}

TEST_F(KeyboardTest, TabIntoAFieldWritesInItAtOnceAndTabLeavesItWithWhatWasWritten) {
  window().press(ui::ActionId::file_demo);
  window().settle();
  window().press(ui::ActionId::step_merge);
  window().settle();
  ASSERT_TRUE(tab_to("merge/lat"));
  window().frames(2);
  window().press({ui::key('A'), true});
  window().type("48.5");
  window().press(tab);
  EXPECT_EQ(window().desk().focused(), "merge/lon");
  EXPECT_DOUBLE_EQ(model().view.placement.latitude_deg, 48.5);
  window().frames(2);
  window().press({ui::key('A'), true});
  window().type("9.25");
  window().press(back_tab);
  EXPECT_DOUBLE_EQ(model().view.placement.longitude_deg, 9.25);
}

TEST_F(KeyboardTest, InADialogTabStaysInside) {
  window().press(ui::ActionId::help_about);
  window().frames(2);
  for (int i = 0; i < 4; ++i) {
    window().press(tab);
    EXPECT_EQ(window().desk().focused(), "dialog/About Stemwise/close");
  }
  window().press(space);
  window().frames(2);
  EXPECT_EQ(model().view.dialog, ui::Dialog::none);
}

/// A tree is selected and a note is being typed.
class NoteTest : public WindowTest {
 protected:
  void type_note(const std::string& text) {
    open_surveys();
    align();
    window().press(ui::ActionId::review_next);
    window().settle();
    tree_ = model().view.selected_tree;
    ASSERT_TRUE(tree_);
    ASSERT_TRUE(window().click("review/note"));
    window().type(text);
  }
  TreeId tree_;
};

TEST_F(NoteTest, WhatIsBeingTypedIsInTheProjectWhenAKeySavesIt) {
  type_note("forked at 2 m");
  window().press(ui::ActionId::file_save);
  window().frames(3);
  EXPECT_EQ(state().trees.at(tree_).note, "forked at 2 m");
  EXPECT_EQ(model().view.dialog, ui::Dialog::save_project);
}

TEST_F(NoteTest, WhatIsBeingTypedIsKeptWhenACommandIsSearchedFor) {
  type_note("leans");
  window().press(ui::ActionId::help_palette);
  window().frames(3);
  window().press({ui::Key::escape});
  window().frames(2);
  window().press(ui::ActionId::review_next);
  window().settle();
  EXPECT_NE(model().view.selected_tree, tree_);
  EXPECT_EQ(state().trees.at(tree_).note, "leans");
  EXPECT_EQ(state().edit_log.back().after, "leans");
}

TEST_F(NoteTest, ClosingTheWindowAsksForWhatIsBeingTyped) {
  type_note("to be felled");
  window().desk().ask_to_close();
  window().frames(4);
  EXPECT_EQ(state().trees.at(tree_).note, "to be felled");
  EXPECT_EQ(model().view.dialog, ui::Dialog::leave);
  EXPECT_FALSE(window().desk().wants_close());
}

TEST_F(KeyboardTest, EnterChoosesInAListAndPressesAButtonButNotWithTheStrokeThatEndsAText) {
  open_surveys();
  align();
  window().press(ui::ActionId::step_report);
  window().frames(3);
  ASSERT_TRUE(tab_to("export/format"));
  const std::string before = window().value("export/format");
  window().press({ui::Key::enter});
  window().frames(3);
  window().press({ui::Key::down});
  window().frames(2);
  window().press({ui::Key::enter});
  window().frames(3);
  EXPECT_NE(window().value("export/format"), before);
  ASSERT_TRUE(window().click("report/area"));
  window().type("2");
  const std::size_t jobs = model().jobs.views().size();
  window().press({ui::Key::enter});
  window().frames(5);
  EXPECT_EQ(model().jobs.views().size(), jobs);
  EXPECT_DOUBLE_EQ(model().view.report_area_ha, 2.0);
}

TEST_F(KeyboardTest, KeysOfTheMapLeaveTheFocusWhereItIs) {
  open_surveys();
  align();
  window().press(ui::ActionId::step_review);
  window().frames(2);
  window().press(ui::ActionId::view_fit);
  window().frames(2);
  EXPECT_EQ(window().desk().focused(), "");
  window().press(ui::ActionId::color_dbh);
  window().frames(3);
  EXPECT_EQ(model().view.color_by, ui::ColorBy::dbh);
  EXPECT_EQ(window().desk().focused(), "");
  window().press(ui::ActionId::view_blink);
  window().frames(2);
  EXPECT_TRUE(model().view.blink);
  EXPECT_EQ(model().view.step, ui::Step::review);
}

TEST_F(WindowTest, ANumberFieldTakesADecimalCommaAndKeepsItsValueWhileTheTextIsNoNumber) {
  open_surveys();
  align();
  window().press(ui::ActionId::step_report);
  window().settle();
  ASSERT_TRUE(window().fill("report/area", "1,5"));
  EXPECT_DOUBLE_EQ(model().view.report_area_ha, 1.5);
  ASSERT_TRUE(window().fill("report/area", "1.234,5"));
  EXPECT_DOUBLE_EQ(model().view.report_area_ha, 1234.5);
  for (const char* text : {"1.37,5", "12,,5", "1'5", "abc"}) {
    ASSERT_TRUE(window().fill("report/area", text));
    window().frames(2);
    EXPECT_EQ(window().value("report/area/refused"), text);  // also after the field was left
    EXPECT_DOUBLE_EQ(model().view.report_area_ha, 1234.5) << text;
  }
  ASSERT_TRUE(window().fill("report/area", "2"));
  window().frames(2);
  EXPECT_EQ(window().desk().registry().find("report/area/refused"), nullptr);
}

TEST_F(WindowTest, AKeyThatDoesNothingJustNowSaysWhy) {
  open_surveys();
  align();
  window().press(ui::ActionId::step_review);
  window().frames(2);
  window().press(ui::ActionId::review_dead);
  window().frames(2);
  ASSERT_FALSE(model().notices.all().empty());
  EXPECT_EQ(model().notices.all().front().title, "Mark as dead: Select a tree first");
}

}  // namespace
}  // namespace stemwise
