#include <gtest/gtest.h>

#include "tests/app/window/window_fixture.hpp"
#include "ui/actions/availability.hpp"
#include "ui/panels/menu_bar.hpp"

namespace stemwise {
namespace {

// The walk through the registry of actions: whatever a person can ask for is in a menu, has a key, is in the palette and on
// the sheet of keys, and says why where it cannot be done just now.

class RegistryTest : public WindowTest {
 protected:
  ui::Availabilities available() { return ui::availabilities(model().document.project(), model().document.derived(), model().view, model().status); }

  void expect_reasons(const char* situation) {
    const ui::Availabilities now = available();
    int greyed = 0;
    for (const ui::Action& a : ui::all_actions()) {
      const ui::Availability& one = now[static_cast<std::size_t>(a.id)];
      if (one.enabled()) continue;
      ++greyed;
      EXPECT_GE(one.why_not.size(), 10u) << a.name << " " << situation;
      EXPECT_TRUE(std::isupper(static_cast<unsigned char>(one.why_not.front()))) << a.name << ": " << one.why_not;
      EXPECT_FALSE(one.why_not.ends_with(".")) << a.name << ": " << one.why_not;
    }
    EXPECT_GT(greyed, 0) << situation;
  }

  static std::string first_of(const std::string& menu) {
    for (const ui::Action& a : ui::all_actions())
      if (ui::menu_label(a.menu) == menu) return a.name;
    return "";
  }

  /// The key of what is greyed out does nothing.
  void expect_dead_keys(const char* situation) {
    const ui::Availabilities now = available();
    for (const ui::Action& a : ui::all_actions()) {
      if (now[static_cast<std::size_t>(a.id)].enabled()) continue;
      const std::uint64_t revision = model().document.revision();
      const ui::ViewState before = model().view;
      window().press(a.id);
      EXPECT_EQ(model().document.revision(), revision) << a.name << " " << situation;
      EXPECT_EQ(model().view.tool, before.tool) << a.name << " " << situation;
      EXPECT_EQ(model().view.dialog, before.dialog) << a.name << " " << situation;
    }
  }
};

TEST_F(RegistryTest, EveryActionIsInItsMenuOnTheKeysSheetAndInThePalette) {
  for (const char* menu : {"File", "Edit", "View", "Align", "Review", "Export", "Help"}) {
    ASSERT_TRUE(window().click(std::string("menu/") + menu)) << menu;
    for (const ui::Action& a : ui::all_actions()) {
      if (std::string(ui::menu_label(a.menu)) != menu) continue;
      const std::string more = ui::submenu_label(a.id);
      if (!more.empty() && window().desk().registry().find(std::string("menu/") + a.name) == nullptr) {
        ASSERT_TRUE(window().click("menu/more/" + more)) << a.name;
      }
      const ui::WidgetEntry* entry = window().desk().registry().find(std::string("menu/") + a.name);
      ASSERT_NE(entry, nullptr) << a.name;
      EXPECT_EQ(entry->enabled, available()[static_cast<std::size_t>(a.id)].enabled()) << a.name;
    }
    window().move_to(800, 900);  // a submenu under the mouse would open again
    for (int i = 0; i < 4 && window().desk().registry().find(std::string("menu/") + first_of(menu)) != nullptr; ++i) {  // a submenu, then its menu
      window().press({ui::Key::escape});
      window().frames(2);
    }
  }
  window().press(ui::ActionId::help_keys);
  window().frames(2);
  for (const ui::Action& a : ui::all_actions()) {
    EXPECT_EQ(window().value(std::string("keys/") + a.name), to_string(a.chord)) << a.name;
    EXPECT_FALSE(to_string(a.chord).empty()) << a.name;
  }
  window().press({ui::Key::escape});
  window().frames(2);
  window().press(ui::ActionId::help_palette);
  window().frames(3);
  for (const ui::Action& a : ui::all_actions()) {
    if (a.id == ui::ActionId::help_palette) continue;  // open already
    EXPECT_EQ(window().value(std::string("palette/") + a.name), a.label) << a.name;
  }
}

TEST_F(RegistryTest, WhatCannotBeDoneSaysWhyInEverySituation) {
  expect_reasons("in an empty window");
  expect_dead_keys("in an empty window");
  open_surveys();
  expect_reasons("before the alignment");
  expect_dead_keys("before the alignment");
  align();
  window().press(ui::ActionId::step_review);
  expect_reasons("with nothing selected");
  const TreeId tree = lonely_matched_tree();
  ASSERT_TRUE(tree);
  click_in_map(tree);
  expect_reasons("with one tree");
  expect_dead_keys("with one tree");
  const auto& trees = model().document.derived().tables.trees;
  model().view.group = {trees[0].tree, trees[1].tree, trees[2].tree};
  window().frames(2);
  expect_reasons("with several trees");
  expect_dead_keys("with several trees");
}

}  // namespace
}  // namespace stemwise
