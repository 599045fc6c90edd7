#include "core/survey/stand_change.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/random.hpp"
#include "core/geometry/shared_area.hpp"
#include "core/survey/report_model.hpp"
#include "core/survey/stand_growth.hpp"
#include "tests/core/project/small_project.hpp"

namespace stemwise {
namespace {

double circle_sq_m(double d_m) { return std::numbers::pi / 4.0 * d_m * d_m; }

Polygon square(double x, double y, double side) { return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}}; }

/// Two surveys of the 50 m x 10 m grid: of 20 trees one (30 cm + 4) is gone later, one small stem is new, one is marked dead.
Project changed_project() {
  Inventory before = test::grid_inventory("2013", date_from_civil(2013, 7, 1), 20, 0.0);
  Inventory after = test::grid_inventory("2018", date_from_civil(2018, 7, 1), 20, 0.02);
  after.stems[4].x_m = 22.0, after.stems[4].y_m = 2.5, after.stems[4].dbh_m = 0.31, after.stems[4].species = "new";
  after.stems[7].status = StemStatus::dead;
  Project project;
  project.execute(add_inventory(before));
  project.execute(add_inventory(after));
  SurveyAlignment alignment = test::straight_alignment(project.state());
  std::erase_if(alignment.matches, [](const Match& m) { return m.a.index == 4; });
  std::vector<std::pair<InventoryId, Coverage>> coverages;
  for (const auto& inventory : project.state().inventories) coverages.emplace_back(inventory->id, Coverage{square(-20, -20, 100), CoverageSource::drawn});
  project.execute(apply_alignment(alignment, coverages));
  return project;
}

TEST(StandChange, PutsEveryLivingStemIntoOneComponentSoThatTheyBalance) {
  const Project project = changed_project();
  const auto changes = stand_changes(project.state(), derive_tables(project.state()));
  ASSERT_EQ(changes.size(), 1u);
  const StandChange& change = changes[0];
  EXPECT_EQ(of(change.all, Component::survivor).stems, 18);
  EXPECT_EQ(of(change.all, Component::missing).stems, 1);
  EXPECT_EQ(of(change.all, Component::dead).stems, 1);
  EXPECT_EQ(of(change.all, Component::ingrowth).stems, 1);
  EXPECT_EQ(earlier_stock(change.all).stems, 20);
  EXPECT_EQ(later_stock(change.all).stems, 19);
  double earlier = 0.0, later = 0.0;
  for (int i = 0; i < 20; ++i) {
    earlier += circle_sq_m(0.30 + 0.01 * i);
    if (i != 7) later += circle_sq_m(i == 4 ? 0.31 : 0.32 + 0.01 * i);
  }
  EXPECT_NEAR(earlier_stock(change.all).earlier_sq_m, earlier, 1e-12);
  EXPECT_NEAR(later_stock(change.all).later_sq_m, later, 1e-12);
  EXPECT_NEAR(change.net_change_sq_m(), later - earlier, 1e-12);
}

TEST(StandChange, CountsLossesByTheirEarlierDbh) {
  const Project project = changed_project();
  const StandChange change = stand_changes(project.state(), derive_tables(project.state())).front();
  EXPECT_NEAR(of(change.all, Component::missing).earlier_sq_m, circle_sq_m(0.34), 1e-12);
  EXPECT_NEAR(of(change.all, Component::dead).earlier_sq_m, circle_sq_m(0.37), 1e-12);
  EXPECT_EQ(of(change.all, Component::dead).later_sq_m, 0.0);
  for (const ClassChange& row : change.by_class) EXPECT_EQ(of(row.table, Component::dead).stems, row.low_cm == 35.0 ? 1 : 0) << row.low_cm;
}

TEST(StandChange, TakesTheAreaGivenOrWhatBothSurveysCoveredAndNeverAnother) {
  Project project = changed_project();
  const InventoryId second = project.state().inventories[1]->id;
  project.execute(set_coverage(second, {square(30, -20, 100), CoverageSource::drawn}));
  const StandChange shared = stand_changes(project.state(), derive_tables(project.state())).front();
  ASSERT_TRUE(shared.area_ha);
  EXPECT_NEAR(*shared.area_ha, 0.5, 1e-9);
  EXPECT_EQ(shared.area_source, "ground covered by both surveys");
  const StandChange given = stand_changes(project.state(), derive_tables(project.state()), {.area_ha = 2.0}).front();
  EXPECT_EQ(*given.area_ha, 2.0);
  Project bare = test::aligned_project();
  const StandChange none = stand_changes(bare.state(), derive_tables(bare.state())).front();
  EXPECT_FALSE(none.area_ha);
  EXPECT_FALSE(periodic_increment(none)->per_ha);
}

TEST(StandChange, CountsPerHectareOnlyWhatStandsOnTheGroundThatWasDrawn) {
  Project project = changed_project();  // stems every 5 m: x 0 to 45, y 0 and 5
  for (const auto& inventory : project.state().inventories) project.execute(set_coverage(inventory->id, {square(-2.5, -2.5, 25), CoverageSource::drawn}));
  const Tables tables = derive_tables(project.state());
  const StandChange change = stand_changes(project.state(), tables).front();
  EXPECT_NEAR(*change.area_ha, 0.0625, 1e-9);
  EXPECT_EQ(earlier_stock(change.all).stems, 10);
  EXPECT_GT(change.beyond_drawn, 0);
  const ReportModel model = make_report_model(project.state(), tables, {});
  EXPECT_EQ(model.surveys[0].stems_with_dbh, 10);
  EXPECT_EQ(model.surveys[0].beyond_area, 10);
  const ReportModel given = make_report_model(project.state(), tables, {.area_ha = 1.0});
  EXPECT_EQ(given.surveys[0].stems_with_dbh, 20);
  EXPECT_EQ(given.surveys[0].beyond_area, 0);
}

TEST(StandChange, KeepsTreesThatWereNotSurveyedOutOfMortality) {
  Project project = changed_project();
  project.execute(set_coverage(project.state().inventories[1]->id, {square(-20, -20, 30), CoverageSource::drawn}));
  const StandChange change = stand_changes(project.state(), derive_tables(project.state())).front();
  EXPECT_EQ(of(change.all, Component::missing).stems, 0);
  EXPECT_EQ(of(change.all, Component::not_surveyed_after).stems, 1);
}

TEST(StandChange, AnnualisesByTheStemsOwnDates) {
  const Project project = changed_project();
  const StandChange change = stand_changes(project.state(), derive_tables(project.state()), {.area_ha = 0.5}).front();
  ASSERT_TRUE(change.years);
  EXPECT_NEAR(*change.years, 5.0, 0.01);
  const auto increment = periodic_increment(change);
  ASSERT_TRUE(increment);
  EXPECT_TRUE(increment->per_ha);
  EXPECT_NEAR(increment->survivor_growth_sq_m, of(change.all, Component::survivor).growth_sq_m() / *change.years / 0.5, 1e-12);
  EXPECT_NEAR(increment->mortality_sq_m, (circle_sq_m(0.34) + circle_sq_m(0.37)) / *change.years / 0.5, 1e-12);
}

TEST(SharedArea, IsThatOfTheGroundInsideBoth) {
  EXPECT_NEAR(shared_area_sq_m(square(0, 0, 10), square(5, 5, 10)), 25.0, 1e-6);
  EXPECT_EQ(shared_area_sq_m(square(0, 0, 10), square(20, 0, 10)), 0.0);
  const Polygon notch{{{0, 0}, {10, 0}, {10, 10}, {6, 10}, {6, 4}, {4, 4}, {4, 10}, {0, 10}}};
  EXPECT_NEAR(shared_area_sq_m(notch, square(0, 0, 10)), 88.0, 0.1);
}

TEST(StandGrowth, GivesAnIntervalThatHoldsTheTrueMeanAboutAsOftenAsItSays) {
  int held = 0;
  constexpr int runs = 200;
  for (int run = 0; run < runs; ++run) {
    Random random(static_cast<std::uint64_t>(run), 7);
    std::vector<double> values;
    for (int i = 0; i < 120; ++i) values.push_back(std::exp(random.normal(0.0, 0.5)) + random.normal(0.0, 1.4));
    const Estimate mean = bootstrap_mean(values, {.resamples = 400, .seed = 3});
    held += mean.ci95[0] <= std::exp(0.125) && std::exp(0.125) <= mean.ci95[1];
  }
  EXPECT_GE(held, 180);
  EXPECT_LT(held, runs);
}

TEST(StandGrowth, DoesNotLetAFewGrossErrorsMoveTheRobustFigure) {
  Random random(1);
  std::vector<double> values;
  for (int i = 0; i < 200; ++i) values.push_back(random.normal(1.0, 0.5));
  for (int i = 0; i < 6; ++i) values.push_back(60.0);
  const Estimate robust = huber_location(values);
  EXPECT_NEAR(robust.value, 1.0, 0.12);
  EXPECT_GT(bootstrap_mean(values, {}).value, 2.0);
}

TEST(StandGrowth, SaysWhatChangeOfOneTreeIsMoreThanError) { EXPECT_NEAR(detection_limit_m(0.01, 0.01), 0.0277, 1e-4); }

}  // namespace
}  // namespace stemwise
