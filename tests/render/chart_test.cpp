#include <gtest/gtest.h>

#include <algorithm>

#include "core/survey/chart_models.hpp"
#include "demo_forest.hpp"
#include "golden.hpp"
#include "render/chart_painter.hpp"

namespace stemwise::render {
namespace {

using test::DemoForest;

ChartStyle style_of(Theme theme, PixelSize size = {640, 360}) {
  ChartStyle style;
  style.theme = theme;
  style.size = size;
  return style;
}

std::vector<std::pair<std::string, ChartModel>> all_charts(const DemoForest& forest) {
  const auto& ids = forest.tables().inventories;
  TreeId seen_thrice;
  for (const TreeRow& tree : forest.tables().trees)
    if (tree.times_seen == 3) seen_thrice = tree.tree;
  return {{"dbh_classes", dbh_class_chart(forest.state(), forest.tables())},
          {"growth_distribution", growth_distribution_chart(forest.state(), forest.tables(), ids[0], ids[1])},
          {"growth_against_dbh", growth_against_dbh_chart(forest.state(), forest.tables(), ids[0], ids[1])},
          {"dbh_over_time", dbh_over_time_chart(forest.state(), forest.tables(), seen_thrice)},
          {"residuals", residual_chart(forest.state(), forest.tables(), ids[0], ids[1])}};
}

TEST(ChartPainter, ChartsLookAsAgreedInBothThemes) {
  const DemoForest forest(600);
  for (const auto& [name, chart] : all_charts(forest))
    for (const Theme theme : {Theme::light, Theme::dark}) {
      const std::string file = "chart_" + name + (theme == Theme::light ? "_light" : "_dark");
      test::show(paint_chart(chart, style_of(theme)).image, file);
      if (theme == Theme::light || name == "growth_distribution") test::expect_golden(paint_chart(chart, style_of(theme, {420, 260})).image, file);
    }
}

TEST(ChartPainter, ANarrowChartWrapsItsWords) {
  const DemoForest forest(600);
  for (const auto& [name, chart] : all_charts(forest)) test::show(paint_chart(chart, style_of(Theme::light, {236, 250})).image, "chart_narrow_" + name);
}

TEST(ChartPainter, TheSameChartIsTheSameBytes) {
  const DemoForest forest(100);
  const ChartModel chart = dbh_class_chart(forest.state(), forest.tables());
  EXPECT_TRUE(png_bytes(paint_chart(chart, style_of(Theme::light)).image) == png_bytes(paint_chart(chart, style_of(Theme::light)).image));
  EXPECT_TRUE(chart_svg(chart, style_of(Theme::light)) == chart_svg(chart, style_of(Theme::light)));
  EXPECT_NE(chart_svg(chart, style_of(Theme::light)).find("<svg"), std::string::npos);
}

TEST(ChartPainter, ABarUnderTheCursorNamesItsTrees) {
  const DemoForest forest(600);
  const auto& ids = forest.tables().inventories;
  const ChartModel chart = growth_distribution_chart(forest.state(), forest.tables(), ids[0], ids[1]);
  const ChartPicture picture = paint_chart(chart, style_of(Theme::light));
  const ChartBar* highest = &chart.bars[0].bars[0];
  for (const ChartBar& bar : chart.bars[0].bars)
    if (bar.value > highest->value) highest = &bar;
  const Eigen::Vector2d pixel = picture.layout.pixel_of({0.5 * (highest->x_low + highest->x_high), 0.5 * highest->value});
  const auto hit = hit_chart(chart, picture.layout, pixel, 4.0);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->trees, highest->trees);
  EXPECT_NE(hit->text.find("stems"), std::string::npos);
}

TEST(ChartPainter, APointUnderTheCursorIsItsTree) {
  const DemoForest forest(60);
  const auto& ids = forest.tables().inventories;
  const ChartModel chart = growth_against_dbh_chart(forest.state(), forest.tables(), ids[0], ids[1]);
  const ChartPicture picture = paint_chart(chart, style_of(Theme::light));
  for (const ChartPoints& series : chart.points)
    for (const ChartPoint& point : series.points) {
      const Eigen::Vector2d pixel = picture.layout.pixel_of({point.x, point.y});
      if (!picture.layout.contains(pixel)) continue;
      const auto hit = hit_chart(chart, picture.layout, pixel, 4.0);
      ASSERT_TRUE(hit);
      const auto inside = trees_in_chart(chart, picture.layout, pixel - Eigen::Vector2d(1, 1), pixel + Eigen::Vector2d(1, 1));
      EXPECT_TRUE(std::find(inside.begin(), inside.end(), point.tree) != inside.end());
    }
}

TEST(ChartPainter, AnEmptyChartSaysWhy) {
  const DemoForest forest(30, false);
  const auto& state = forest.state();
  const ChartModel chart = growth_distribution_chart(state, forest.tables(), state.inventories[0]->id, state.inventories[1]->id);
  EXPECT_FALSE(chart.empty_text.empty());
  test::show(paint_chart(chart, style_of(Theme::light)).image, "chart_empty");
}

TEST(ChartPainter, WritesPngAndSvgAndRefusesOthers) {
  const DemoForest forest(30);
  const ChartModel chart = dbh_class_chart(forest.state(), forest.tables());
  const std::string folder = testing::TempDir();
  EXPECT_TRUE(write_chart(chart, style_of(Theme::light), folder + "chart.png"));
  EXPECT_TRUE(write_chart(chart, style_of(Theme::light), folder + "chart.svg"));
  EXPECT_FALSE(write_chart(chart, style_of(Theme::light), folder + "chart.doc"));
  EXPECT_FALSE(write_chart(chart, style_of(Theme::light), folder + "no/such/folder/chart.png"));
}

}  // namespace
}  // namespace stemwise::render
