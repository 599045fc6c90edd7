#include <gtest/gtest.h>

#include <sstream>

#include "tests/app/window/window_fixture.hpp"
#include "ui/frame.hpp"

namespace stemwise {
namespace {

class ChartTest : public WindowTest {
 protected:
  void open_growth() {
    open_surveys(300);
    align();
    ASSERT_TRUE(window().click("tabs/Growth"));
    window().settle();
  }
  ui::Rect chart(const std::string& path) { return window().desk().registry().find(path)->rect; }
  /// A place in the chart where there is something; its words.
  bool find_bar(const ui::Rect& rect, float& x, float& y) {
    for (float fx = 0.2f; fx < 0.9f; fx += 0.03f) {
      x = rect.x + fx * rect.width;
      y = rect.bottom() - 56.0f;
      window().move_to(x, y);
      window().frames(2);
      if (!window().value("growth/dbh-change").empty()) return true;
    }
    return false;
  }
};

TEST_F(ChartTest, ABarSelectsItsTreesAndATreeIsMarkedInTheChart) {
  open_growth();
  float x = 0, y = 0;
  ASSERT_TRUE(find_bar(chart("growth/dbh-change"), x, y));
  const std::string tip = window().value("growth/dbh-change");
  EXPECT_NE(tip.find("stem"), std::string::npos) << tip;
  window().click_at(x, y);
  window().settle();
  const std::size_t selected = std::max<std::size_t>(model().view.group.size(), model().view.selected_tree ? 1 : 0);
  EXPECT_NE(tip.find(": " + std::to_string(selected) + " stem"), std::string::npos) << tip << ", selected " << selected;
  EXPECT_EQ(model().viewport.viewport().options().selected.size(), selected);
}

TEST_F(ChartTest, ARectangleInAChartSelectsEverythingInIt) {
  open_growth();
  const ui::Rect rect = chart("growth/dbh-change");
  window().drag(rect.x + 40, rect.y + rect.height - 40, rect.right() - 10, rect.y + 60);
  window().settle();
  EXPECT_GT(model().view.group.size(), 20u);
}

TEST_F(ChartTest, EveryChartCanBeChosenAndSavedAsPictureAndDrawing) {
  open_growth();
  for (const char* name : {"DBH classes", "DBH change against DBH", "Residual distances", "Residual directions"}) {
    ASSERT_TRUE(window().click("growth/choose/0"));
    window().frames(2);
    ASSERT_TRUE(window().click(std::string("growth/choose/0/") + name)) << name;
    window().settle();
    EXPECT_STREQ(ui::chart_label(model().view.chart), name);
  }
  ASSERT_TRUE(window().has("growth/residual-directions"));
  const ui::Rect rose = chart("growth/residual-directions");
  window().move_to(rose.center_x() + 6, rose.center_y() + 20);
  window().frames(3);
  EXPECT_EQ(window().value("growth/residual-directions").find("towards "), 0u) << window().value("growth/residual-directions");
  for (const char* suffix : {".svg", ".png"}) {
    ASSERT_TRUE(window().click("growth/residual-directions/save"));
    window().frames(3);
    ASSERT_TRUE(window().fill("files/path", folder_.string()));
    window().frames(2);
    ASSERT_TRUE(window().fill("files/name", std::string("rose") + suffix));
    ASSERT_TRUE(window().click("files/accept"));
    window().settle();
    EXPECT_GT(fs::file_size(folder_ / (std::string("rose") + suffix)), 1500u);
  }
}

TEST_F(ChartTest, TheChartsAreOfThePairOfSurveysThatIsChosen) {
  open_surveys(220, {2012, 2017, 2022});
  align();
  ASSERT_TRUE(window().click("tabs/Growth"));
  window().settle();
  EXPECT_EQ(window().value("growth/1"), "shown");
  ASSERT_TRUE(window().click("growth/0"));
  window().settle();
  EXPECT_EQ(window().value("growth/0"), "shown");
}

}  // namespace
}  // namespace stemwise
