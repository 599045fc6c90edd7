#include <gtest/gtest.h>

#include "render/palette.hpp"
#include "tests/app/window/window_fixture.hpp"
#include "ui/frame.hpp"
#include "ui/text/format.hpp"
#include "ui/theme/tokens.hpp"

namespace stemwise {
namespace {

// What the pictures of the guide cannot prove by themselves.

class LookTest : public WindowTest {
 protected:
  const ui::Rect& rect(const std::string& path) { return window().desk().registry().find(path)->rect; }
};

TEST_F(LookTest, TheCalloutOfADoubtfulMatchNamesTheTwoDiametersThatItIsAbout) {
  open_surveys(240, {2013, 2018, 2023});
  align();
  window().press(ui::ActionId::step_review);
  const Tables& tables = model().document.derived().tables;
  const auto doubtful = std::find_if(tables.queue.begin(), tables.queue.end(), [&](const QueueRow& q) {
    return !q.decided && q.match && tables.matches[*q.match].dbh_a_m && tables.matches[*q.match].dbh_b_m;
  });
  ASSERT_NE(doubtful, tables.queue.end());
  const MatchRow& match = tables.matches[*doubtful->match];
  const std::string span = ui::dbh_text(match.dbh_a_m) + " to " + ui::dbh_text(match.dbh_b_m) + " cm";
  model().view.selected_tree = doubtful->tree;
  window().settle();
  EXPECT_EQ(window().value("viewport/hover"), tree_label(match.tree) + " · " + span);
}

TEST_F(LookTest, LargeTextInASmallWindowLeavesNothingOnTopOfAnotherPanel) {
  open_surveys();
  align();
  window().press(ui::ActionId::step_review);
  window().resize(1920, 1080);
  for (int i = 0; i < 10; ++i) window().press(ui::ActionId::view_zoom_in);
  window().settle();
  EXPECT_EQ(model().view.zoom_percent, 200.0);
  const ui::Rect map = rect("viewport");
  EXPECT_LE(rect("tabs/Jobs").right(), map.right());
  EXPECT_LE(rect("viewport/layers").right(), map.right());
  EXPECT_GE(rect("viewport/map").x, map.x);
}

TEST_F(LookTest, AKeyWithAltAndHomeMoveNoFocus) {
  open_surveys();
  align();
  window().press(ui::ActionId::step_review);
  window().press(ui::ActionId::heat_times_seen);
  EXPECT_EQ(window().desk().focused(), "");
  window().press(ui::ActionId::view_fit);
  EXPECT_EQ(window().desk().focused(), "");
}

TEST(LegendColours, AreThoseOfTheMap) {
  for (std::size_t i = 0; i < fate_count; ++i) {
    const auto fate = static_cast<Fate>(i);
    const ui::Color listed = ui::fate_color(fate);
    const render::Rgba drawn = render::fate_colour(fate);
    EXPECT_EQ(std::tuple(listed.r, listed.g, listed.b), std::tuple(drawn.r, drawn.g, drawn.b)) << to_string(fate);
  }
}

}  // namespace
}  // namespace stemwise
