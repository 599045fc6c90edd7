#include <gtest/gtest.h>

#include "core/geometry/drawn_polygon.hpp"
#include "tests/app/window/window_fixture.hpp"

namespace stemwise {
namespace {

class ShapeTest : public WindowTest {
 protected:
  void open_aligned() {
    open_surveys();
    align();
    model().notices.clear();  // none of them over the map
    window().frames(2);
  }
  void click_corner(float x, float y) {
    const ui::Rect map = window().desk().registry().find("viewport")->rect;
    window().click_at(map.x + x, map.y + y);
  }
};

TEST_F(ShapeTest, ALassoByClicksSelectsTheTreesInIt) {
  open_aligned();
  window().press(ui::ActionId::tool_lasso);
  ASSERT_EQ(model().view.tool, ui::Tool::lasso);
  const std::vector<Eigen::Vector2d> corners{{300, 120}, {640, 150}, {600, 420}, {340, 380}};
  for (const Eigen::Vector2d& c : corners) click_corner(static_cast<float>(c.x()), static_cast<float>(c.y()));
  click_corner(700, 300);
  EXPECT_EQ(model().status.shape.size(), 6u);  // five corners and the cursor
  window().press({static_cast<ui::Key>(259)});  // Backspace takes the last one back
  const std::vector<TreeId> expected = model().viewport.viewport().trees_in_polygon(corners);
  ASSERT_GE(expected.size(), 4u);
  window().press({ui::Key::enter});
  window().settle();
  EXPECT_EQ(model().view.group, expected);
  EXPECT_EQ(model().view.tool, ui::Tool::select);
  EXPECT_TRUE(model().status.shape.empty());
}

TEST_F(ShapeTest, AClickOnTheFirstCornerEndsTheLassoAndEscapeForgetsIt) {
  open_aligned();
  window().press(ui::ActionId::tool_lasso);
  click_corner(300, 120);
  click_corner(640, 150);
  window().press({ui::Key::escape});
  window().frames(2);
  EXPECT_EQ(model().view.tool, ui::Tool::select);
  EXPECT_TRUE(model().status.shape.empty());
  window().press(ui::ActionId::tool_lasso);
  for (const auto& [x, y] : {std::pair(250, 110), std::pair(700, 110), std::pair(700, 430), std::pair(250, 110)}) click_corner(static_cast<float>(x), static_cast<float>(y));
  window().settle();
  EXPECT_GE(model().view.group.size(), 4u);
}

TEST_F(ShapeTest, TheCoverageIsDrawnAndEstimatedAgain) {
  open_aligned();
  window().press(ui::ActionId::step_inventories);
  const InventoryId id = model().document.derived().tables.inventories.back();
  model().view.selected_inventory = id;
  window().settle();
  const ProjectState before = state();
  EXPECT_NE(window().value("details/coverage").find("ha, from the outline of the stems"), std::string::npos) << window().value("details/coverage");
  window().press(ui::ActionId::edit_coverage);
  for (const auto& [x, y] : {std::pair(300, 120), std::pair(640, 150), std::pair(600, 420), std::pair(340, 380)}) click_corner(static_cast<float>(x), static_cast<float>(y));
  window().press({ui::Key::enter});
  window().settle();
  ASSERT_EQ(state().coverages.at(id).source, CoverageSource::drawn);
  EXPECT_EQ(state().coverages.at(id).in_inventory.corners_m.size(), 4u);
  EXPECT_LT(area_sq_m(state().coverages.at(id).in_inventory), area_sq_m(before.coverages.at(id).in_inventory));
  EXPECT_NE(window().value("details/coverage").find("drawn by hand"), std::string::npos);
  window().press(ui::ActionId::edit_undo);
  window().settle();
  EXPECT_EQ(state(), before);
  window().press(ui::ActionId::edit_redo);
  window().settle();
  ASSERT_TRUE(window().click("details/estimate_coverage"));
  window().settle();
  EXPECT_EQ(state().coverages.at(id).source, CoverageSource::stems);
}

}  // namespace
}  // namespace stemwise
