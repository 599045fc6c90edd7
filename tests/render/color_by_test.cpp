#include "render/color_by.hpp"

#include <gtest/gtest.h>

#include "render/heat_map.hpp"
#include "tests/core/project/small_project.hpp"

namespace stemwise::render {
namespace {

TEST(Colouring, ChangeOfSurveysWithoutDatesIsColouredAsAWholeAndTheLegendSaysSo) {
  Project project = stemwise::test::aligned_project();
  const Tables dated = derive_tables(project.state());
  EXPECT_EQ(Colouring(project.state(), dated, ColorBy::growth, Theme::light).legend().unit, "mm per year");
  for (const auto& inventory : std::vector(project.state().inventories)) project.execute(set_inventory_date(inventory->id, std::nullopt));
  Tables tables = derive_tables(project.state());
  const Colouring whole(project.state(), tables, ColorBy::growth, Theme::light);
  EXPECT_EQ(whole.legend().unit, "cm in all (no dates)");
  tables.trees.front().dbh_per_inventory_m = {0.30, std::nullopt, 0.36};
  const MarkStyle grown = whole.style_of(tables.observations.front(), &tables.trees.front(), true);
  EXPECT_EQ(grown.shape, MarkShape::disc);
  tables.trees.front().dbh_per_inventory_m = {0.30, std::nullopt, std::nullopt};
  EXPECT_EQ(whole.style_of(tables.observations.front(), &tables.trees.front(), true).shape, MarkShape::hollow);
}

TEST(HeatMap, AContourRunsBetweenTheNodesAndSkipsWhatIsNotKnown) {
  HeatGrid heat;
  heat.columns = 3;
  heat.rows = 2;
  heat.step_m = 2.0;
  heat.low_m = {10.0, 20.0};
  heat.value = {1, 1, 3, 1, 1, 3};
  heat.is_known.assign(6, 1);
  const auto line = contour_of(heat, 2.0F);
  ASSERT_EQ(line.size(), 1u);
  EXPECT_DOUBLE_EQ(line[0].first.x(), 13.0);
  EXPECT_DOUBLE_EQ(line[0].second.x(), 13.0);
  EXPECT_DOUBLE_EQ(std::abs(line[0].first.y() - line[0].second.y()), 2.0);
  heat.is_known[5] = 0;
  EXPECT_TRUE(contour_of(heat, 2.0F).empty());
}

}  // namespace
}  // namespace stemwise::render
