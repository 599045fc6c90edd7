#include "core/survey/chart_models.hpp"

#include <gtest/gtest.h>

#include "../project/small_project.hpp"

namespace stemwise {
namespace {

double total(const ChartBars& series) {
  double sum = 0.0;
  for (const ChartBar& bar : series.bars) sum += bar.value;
  return sum;
}

TEST(ChartModels, EveryMeasuredStemIsInOneClassOfItsSurvey) {
  const Project project = test::aligned_project();
  const ChartModel chart = dbh_class_chart(project.state(), derive_tables(project.state()));
  ASSERT_EQ(chart.bars.size(), 3U);
  for (const ChartBars& series : chart.bars) EXPECT_EQ(total(series), 20.0);
  EXPECT_EQ(chart.bars[0].name, "2013");
  EXPECT_EQ(chart.x.unit, "cm");
}

TEST(ChartModels, ABarListsTheTreesItCounts) {
  const Project project = test::aligned_project();
  const Tables tables = derive_tables(project.state());
  const ChartModel chart = growth_distribution_chart(project.state(), tables, tables.inventories[0], tables.inventories[1]);
  ASSERT_EQ(chart.bars.size(), 1U);
  for (const ChartBar& bar : chart.bars[0].bars) EXPECT_EQ(static_cast<double>(bar.trees.size()), bar.value);
  EXPECT_EQ(total(chart.bars[0]), 20.0);
}

TEST(ChartModels, ABarSaysWhichClassItCountsAndWhetherThatHasAnEnd) {
  const Project project = test::aligned_project();
  const Tables tables = derive_tables(project.state());
  const ChartModel chart = dbh_class_chart(project.state(), tables);
  for (const ChartBars& series : chart.bars)
    for (std::size_t i = 0; i < series.bars.size(); ++i) {
      const std::string& label = series.bars[i].label;
      const bool is_outer = i == 0 || i + 1 == series.bars.size();
      EXPECT_TRUE(label.find(" to ") != std::string::npos || is_outer) << label;
      EXPECT_NE(label.find(" cm"), std::string::npos) << label;
      if (!is_outer) {
        EXPECT_EQ(label, chart.bars.front().bars[i].label);  // the class, not the bar's own edges in it
      }
    }
}

TEST(ChartModels, GrowthIsDrawnInCentimetresWithItsBand) {
  const Project project = test::aligned_project();
  const Tables tables = derive_tables(project.state());
  const ChartModel chart = growth_distribution_chart(project.state(), tables, tables.inventories[0], tables.inventories[1]);
  ASSERT_EQ(chart.bands.size(), 1U);
  EXPECT_NEAR(chart.bands[0].low, 1.0, 1e-6);  // every tree grew by 1 cm
  EXPECT_NEAR(chart.bands[0].high, 1.0, 1e-6);
}

TEST(ChartModels, OneTreesHistoryHasAPointPerSighting) {
  const Project project = test::aligned_project();
  const Tables tables = derive_tables(project.state());
  const ChartModel chart = dbh_over_time_chart(project.state(), tables, tables.trees[4].tree);
  ASSERT_EQ(chart.points.size(), 1U);
  ASSERT_EQ(chart.points[0].points.size(), 3U);
  EXPECT_NEAR(chart.points[0].points[0].y, 34.0, 1e-9);
  EXPECT_LT(chart.points[0].points[0].x, chart.points[0].points[2].x);
  EXPECT_EQ(chart.x.tick_labels, (std::vector<std::string>{"2013", "2018", "2023"}));
}

TEST(ChartModels, AProjectWithoutMatchesSaysWhatIsMissing) {
  Project project;
  project.execute(add_inventory(test::grid_inventory("a", date_from_civil(2013, 7, 1), 5, 0.0)));
  project.execute(add_inventory(test::grid_inventory("b", date_from_civil(2018, 7, 1), 5, 0.0)));
  const Tables tables = derive_tables(project.state());
  const InventoryId a = project.state().inventories[0]->id, b = project.state().inventories[1]->id;
  EXPECT_FALSE(growth_distribution_chart(project.state(), tables, a, b).empty_text.empty());
  EXPECT_FALSE(growth_against_dbh_chart(project.state(), tables, a, b).empty_text.empty());
  EXPECT_FALSE(residual_chart(project.state(), tables, a, b).empty_text.empty());
  EXPECT_EQ(report_charts(project.state(), tables).size(), 1U);
}

}  // namespace
}  // namespace stemwise
