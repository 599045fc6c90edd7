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

}  // namespace
}  // namespace stemwise
