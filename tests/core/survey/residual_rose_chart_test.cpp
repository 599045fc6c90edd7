#include <gtest/gtest.h>

#include "core/project/commands.hpp"
#include "core/project/project.hpp"
#include "core/survey/chart_models.hpp"
#include "core/survey/policy_effect.hpp"

namespace stemwise {
namespace {

/// Two surveys in one frame; every stem of the later one stands 20 cm to the east, and is 2 cm thicker.
Project shifted_surveys() {
  Project project;
  SurveyAlignment alignment;
  for (int year : {2018, 2023}) {
    Inventory inventory;
    inventory.name = std::to_string(year);
    inventory.date = date_from_civil(year, 7, 1);
    for (int i = 0; i < 12; ++i) {
      Stem stem;
      stem.source_id = std::to_string(i + 1);
      stem.x_m = 5.0 * i + (year == 2023 ? 0.2 : 0.0);
      stem.y_m = (i * 7) % 11;
      stem.dbh_m = 0.20 + 0.01 * i + (year == 2023 ? 0.02 : 0.0);
      inventory.stems.push_back(stem);
    }
    project.execute(add_inventory(inventory));
  }
  const InventoryId a = project.state().inventories[0]->id, b = project.state().inventories[1]->id;
  alignment.reference = a;
  for (const InventoryId id : {a, b}) {
    InventoryAlignment one;
    one.inventory = id;
    one.status = id == a ? AlignmentStatus::reference : AlignmentStatus::aligned;
    alignment.inventories.push_back(one);
  }
  for (std::int64_t i = 0; i < 12; ++i) alignment.matches.push_back({{a, i}, {b, i}, 0.2, 0.9, MatchState::automatic, std::nullopt, std::nullopt});
  project.execute(apply_alignment(alignment, {}));
  return project;
}

TEST(ResidualRose, PointsWhereTheLaterSurveyIsShifted) {
  const Project project = shifted_surveys();
  const Tables tables = derive_tables(project.state());
  const ChartModel rose = residual_rose_chart(project.state(), tables, tables.inventories[0], tables.inventories[1]);
  ASSERT_EQ(rose.petals.size(), 16u);
  for (std::size_t i = 0; i < rose.petals.size(); ++i) EXPECT_EQ(rose.petals[i].trees.size(), i == 4 ? 12u : 0u) << i;  // east of north: 90 degrees
  EXPECT_NEAR(rose.petals[4].radius, 1.0, 1e-12);
  EXPECT_NE(rose.note.find("mean shift 20.0 cm towards 90"), std::string::npos) << rose.note;
}

TEST(PolicyEffect, CountsWhatAnotherPolicyWouldChange) {
  const Project project = shifted_surveys();
  const Tables tables = derive_tables(project.state());
  EXPECT_EQ(policy_effect(project.state(), tables, project.state().fusion), PolicyEffect{});
  const PolicyEffect newest = policy_effect(project.state(), tables, FusionPolicy::newest);
  EXPECT_EQ(newest.changed, 12);
  EXPECT_NEAR(newest.mean_change_m, 0.02, 1e-9);
  EXPECT_NEAR(newest.largest_change_m, 0.02, 1e-9);
}

}  // namespace
}  // namespace stemwise
