#include <gtest/gtest.h>

#include "tests/app/window/window_fixture.hpp"

namespace stemwise {
namespace {

TEST_F(WindowTest, TwoSurveysAreComparedByABarThatIsDragged) {
  open_surveys();
  EXPECT_FALSE(window().has("viewport/slide"));
  align();
  window().press(ui::ActionId::view_slide);
  window().frames(3);
  ASSERT_TRUE(window().has("viewport/slide"));
  EXPECT_EQ(window().value("viewport/slide"), "2018 | 2023");
  EXPECT_NE(model().status.viewport.later_texture, 0u);
  EXPECT_NE(model().status.viewport.later_texture, model().status.viewport.texture);
  const ui::Rect bar = window().desk().registry().find("viewport/slide")->rect;
  window().drag(bar.center_x(), bar.center_y(), bar.center_x() - 300, bar.center_y());
  EXPECT_LT(model().view.slide_at, 0.35f);
  window().press({ui::Key::escape});
  window().frames(2);
  EXPECT_FALSE(window().has("viewport/slide"));
  EXPECT_EQ(model().status.viewport.later_texture, 0u);
}

}  // namespace
}  // namespace stemwise
