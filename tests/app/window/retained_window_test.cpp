#include <gtest/gtest.h>

#include "tests/app/window/window_fixture.hpp"

namespace stemwise {
namespace {

class RetainedWindow : public WindowTest {
 protected:
  render::Image picture() {
    const std::string path = (folder_ / "seen.png").string();
    EXPECT_TRUE(window().screenshot(path));
    auto image = render::read_png(path);
    return image ? *image : render::Image{};
  }
  /// What was kept from earlier frames is what drawing all of it would give.
  void expect_up_to_date(const char* what) {
    const render::Image kept = picture();
    window().draw_anew();
    window().frame();
    EXPECT_EQ(window().drawn_share(), 1.0);
    EXPECT_TRUE(kept == picture()) << what;
  }
};

TEST_F(RetainedWindow, APartlyDrawnWindowLooksAsOneDrawnAnew) {
  open_surveys();
  align();
  window().press(ui::ActionId::step_review);
  window().frames(3);
  expect_up_to_date("after aligning");
  const TreeId tree = lonely_matched_tree();
  ASSERT_TRUE(tree);
  click_in_map(tree);
  window().frames(2);
  expect_up_to_date("with a tree and its chart");
  ASSERT_TRUE(window().click("menu/View"));
  window().move_to(120, 300);
  expect_up_to_date("with a menu");
  window().press({ui::Key::escape});
  window().frames(2);
  ASSERT_TRUE(window().click("viewport/layers"));
  expect_up_to_date("with the popup of layers");
  ASSERT_TRUE(window().click("layers/labels"));
  expect_up_to_date("with labels");
  window().press({ui::Key::escape});
  window().frames(2);
  const ui::Rect map = window().desk().registry().find("viewport")->rect;
  window().drag(map.center_x(), map.center_y(), map.center_x() + 80, map.center_y() + 33);
  expect_up_to_date("after a drag");
  window().press(ui::ActionId::view_slide);
  window().frames(2);
  expect_up_to_date("with two surveys side by side");
  window().press(ui::ActionId::view_slide);
  window().press(ui::ActionId::view_theme);
  window().frames(3);
  expect_up_to_date("in the other theme");
  window().press(ui::ActionId::help_keys);
  window().frames(30);  // the window behind it has grown dim
  expect_up_to_date("with the sheet of keys");
  window().press({ui::Key::escape});
  window().resize(1280, 720);
  expect_up_to_date("in another size");
}

TEST_F(RetainedWindow, NothingIsDrawnWhereNothingChanges) {
  open_surveys();
  window().move_to(20, 20);
  window().settle();
  model().notices.clear();
  window().frames(5);
  EXPECT_EQ(window().drawn_share(), 0.0);
  const ui::Rect map = window().desk().registry().find("viewport")->rect;
  const double share = static_cast<double>(map.width) * map.height / (1600.0 * 1000.0);
  window().drag(map.center_x(), map.center_y(), map.center_x() + 20, map.center_y(), 1);
  window().move_to(map.center_x() + 25, map.center_y());
  EXPECT_LT(window().drawn_share(), share + 0.1);
}

}  // namespace
}  // namespace stemwise
