#include <gtest/gtest.h>

#include <cmath>

#include "core/survey/fusion_choices.hpp"
#include "tests/app/run_program.hpp"
#include "tests/app/window/window_fixture.hpp"
#include "ui/frame.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

class MergeTest : public WindowTest {
 protected:
  void open_merge() {
    open_surveys();
    align();
    window().press(ui::ActionId::step_merge);
    window().settle();
  }
  const Tables& tables() { return model().document.derived().tables; }
  static Georeference somewhere() {
    Georeference g;
    g.kind = GeoreferenceKind::anchor;
    g.origin = {48.772140, 9.166210, 412.5};
    g.azimuth_deg = 37.0;
    return g;
  }
  /// A file of control points at trees that are far apart; the last one is wrong by so much to the north.
  std::string control_file(std::size_t points, double wrong_deg) {
    const fs::path path = folder_ / "control.csv";
    std::ofstream file(path);
    file.precision(12);
    file << "tree_id,lat,lon,height_m\n";
    const std::size_t step = tables().trees.size() / points;
    for (std::size_t i = 0; i < points; ++i) {
      const TreeRow& tree = tables().trees[i * step];
      const Geodetic at = geodetic_from_reference(somewhere(), tree.position_m);
      file << tree_label(tree.tree) << "," << at.latitude_deg + (i + 1 == points ? wrong_deg : 0.0) << "," << at.longitude_deg << "," << at.height_m << "\n";
    }
    return path.string();
  }
};

TEST_F(MergeTest, WhatAnotherPolicyWouldChangeIsShownBeforeItIsChosen) {
  open_merge();
  ASSERT_TRUE(model().status.fusion);
  const PolicyEffect newest = model().status.fusion->policies[static_cast<std::size_t>(FusionPolicy::newest)];
  EXPECT_GT(newest.changed, 0);
  EXPECT_EQ(window().value("merge/policy/newest").find(std::to_string(newest.changed) + " trees, mean "), 0u) << window().value("merge/policy/newest");
  const Tables before = tables();
  ASSERT_TRUE(window().click("merge/policy/newest"));
  window().settle();
  EXPECT_EQ(state().fusion, FusionPolicy::newest);
  int changed = 0;
  for (const TreeRow& tree : tables().trees) {
    const TreeRow* earlier = before.find(tree.tree);
    changed += earlier != nullptr && earlier->dbh_m && tree.dbh_m && std::abs(*earlier->dbh_m - *tree.dbh_m) >= 0.0005 ? 1 : 0;
  }
  EXPECT_EQ(changed, newest.changed);
  EXPECT_EQ(window().value("merge/policy/newest"), "chosen");
}

TEST_F(MergeTest, AValuesSourceIsChosenByHandAndUndone) {
  open_merge();
  const TreeId tree = lonely_matched_tree();
  ASSERT_TRUE(tree);
  click_in_map(tree);
  window().settle();
  const TreeRow row = *tables().find(tree);
  const InventoryId other = row.dbh_source == tables().inventories[0] ? tables().inventories[1] : tables().inventories[0];
  std::optional<double> dbh_m;
  for (const ObservationRow* seen : model().document.derived().sightings(tree)) {
    if (seen->stem.inventory == other) dbh_m = seen->dbh_m;
  }
  ASSERT_TRUE(dbh_m);
  const ProjectState before = state();
  ASSERT_TRUE(window().click("merge/tree"));
  window().frames(2);
  ASSERT_TRUE(window().click("merge/source/dbh"));
  window().frames(2);
  ASSERT_TRUE(window().click("merge/source/dbh/" + ui::survey_label(state(), other) + ": " + ui::dbh_text(dbh_m) + " cm"));
  window().settle();
  EXPECT_EQ(fusion_choices(state()).at(tree).dbh, other);
  EXPECT_EQ(tables().find(tree)->dbh_source, other);
  EXPECT_EQ(tables().find(tree)->dbh_m, dbh_m);
  window().press(ui::ActionId::edit_undo);
  EXPECT_EQ(state(), before);
}

TEST_F(MergeTest, ConflictsBetweenSurveysAreListedAndLeadToTheirTree) {
  window().press(ui::ActionId::file_demo);
  window().settle();
  align();
  window().press(ui::ActionId::step_merge);
  window().settle();
  const auto conflicts = model().document.derived().conflicts;
  ASSERT_FALSE(conflicts.empty());
  ASSERT_TRUE(window().click("merge/conflicts"));
  window().frames(2);
  EXPECT_EQ(window().value("conflicts/row/0"), tree_label(conflicts.front().tree));
  ASSERT_TRUE(window().click("conflicts/row/0"));
  window().settle();
  EXPECT_EQ(model().view.selected_tree, conflicts.front().tree);
}

TEST_F(MergeTest, ControlPointsShowTheirResidualsBeforeAnythingIsPlaced) {
  open_merge();
  const ProjectState before = state();
  ASSERT_TRUE(window().click("merge/kind/control"));
  window().frames(2);
  EXPECT_FALSE(window().has("merge/apply"));
  ASSERT_TRUE(window().fill("merge/control_file", control_file(6, 0.0002)));  // the last one is 22 m off
  window().settle();
  ASSERT_TRUE(model().status.placement);
  ASSERT_TRUE(model().status.placement->usable) << to_string(model().status.placement->issues.front());
  const Georeference& found = model().status.placement->georeference;
  ASSERT_EQ(found.residuals.size(), 6u);
  EXPECT_FALSE(found.residuals.back().used);
  EXPECT_GT(found.residuals.back().residual_m, 15.0);
  EXPECT_EQ(window().value("merge/residual/" + found.residuals.back().name).find("left out") == std::string::npos, false);
  ASSERT_EQ(model().status.control_marks.size(), 6u);  // on the map too
  EXPECT_TRUE(model().status.control_marks.back().warning);
  EXPECT_EQ(state(), before);
  ASSERT_TRUE(window().click("merge/apply"));
  window().settle();
  EXPECT_EQ(state().georeference.kind, GeoreferenceKind::anchor);
  EXPECT_NEAR(state().georeference.azimuth_deg, 37.0, 0.05);
  const Geodetic origin = geodetic_from_reference(state().georeference, Eigen::Vector3d::Zero());
  EXPECT_NEAR(origin.latitude_deg, somewhere().origin.latitude_deg, 2e-6);
  window().press(ui::ActionId::edit_undo);
  EXPECT_EQ(state(), before);
}

TEST_F(MergeTest, TwoTreesWithTypedPlacesAreEnough) {
  open_merge();
  ASSERT_TRUE(window().click("merge/kind/control"));
  const Tables now = tables();
  for (const TreeRow* tree : {&now.trees.front(), &now.trees.back()}) {
    model().view.selected_tree = tree->tree;
    window().frames(2);
    const Geodetic at = geodetic_from_reference(somewhere(), tree->position_m);
    char text[40];
    std::snprintf(text, sizeof text, "%.8f", at.latitude_deg);
    ASSERT_TRUE(window().fill("merge/typed/lat", text));
    std::snprintf(text, sizeof text, "%.8f", at.longitude_deg);
    ASSERT_TRUE(window().fill("merge/typed/lon", text));
    ASSERT_TRUE(window().click("merge/typed/add"));
  }
  window().settle();
  ASSERT_TRUE(model().status.placement && model().status.placement->usable);
  EXPECT_NEAR(model().status.placement->georeference.azimuth_deg, 37.0, 0.1);
}

TEST_F(MergeTest, ASystemThatDoesNotFitIsRefusedInPlainWords) {
  open_merge();
  ASSERT_TRUE(window().click("merge/kind/crs"));
  ASSERT_TRUE(window().fill("merge/epsg", "25832"));
  window().settle();
  ASSERT_TRUE(model().status.placement);
  EXPECT_FALSE(model().status.placement->usable);  // coordinates near zero
  ASSERT_FALSE(model().status.placement->issues.empty());
  EXPECT_EQ(model().status.placement->issues.back().text.find("--"), std::string::npos) << model().status.placement->issues.back().text;
  EXPECT_FALSE(window().has("merge/apply"));
}

TEST_F(MergeTest, AnAnchorIsPlacedAfterItsPlaceWasShown) {
  open_merge();
  ASSERT_TRUE(window().click("merge/kind/anchor"));
  ASSERT_TRUE(window().fill("merge/lat", "48.77214"));
  ASSERT_TRUE(window().fill("merge/lon", "9.16621"));
  ASSERT_TRUE(window().fill("merge/azimuth", "37"));
  window().settle();
  EXPECT_NE(window().value("merge/preview").find("° N, 9.16"), std::string::npos) << window().value("merge/preview");
  EXPECT_NE(window().value("merge/preview").find("EPSG:32632"), std::string::npos);
  ASSERT_TRUE(window().click("merge/apply"));
  window().settle();
  EXPECT_EQ(state().georeference.kind, GeoreferenceKind::anchor);
  EXPECT_EQ(window().value("steps/4"), "UTM 32N, EPSG:32632");
  EXPECT_FALSE(window().has("merge/apply"));  // it lies there already
}

TEST_F(MergeTest, AGnssTrackPlacesAWalkThatWasSurveyedWithIt) {
  const auto made = testing::run_stemwise({"simulate", "-o", (folder_ / "walk").string(), "--frames", "--stems", "250", "--years", "2021,2023", "-q"});
  ASSERT_EQ(made.code, 0) << made.err;
  window().desk().drop({(folder_ / "walk" / "2021").string(), (folder_ / "walk" / "2023").string()});
  window().settle();
  align();
  const Inventory& reference = *state().find(state().reference);
  ASSERT_TRUE(reference.frames);
  std::ofstream file(folder_ / "track.csv");
  file.precision(14);
  file << "timestamp,lat,lon,height_m,sd_m\n";
  for (std::size_t i = 0; i < reference.frames->frames.size(); ++i) {
    const TrajectoryPose& pose = reference.frames->frames[i].pose;
    const double wobble_m = 0.3 * std::sin(1.7 * static_cast<double>(i));  // what a good receiver is off by
    const Geodetic at = geodetic_from_reference(somewhere(), pose.survey_from_frame.translation_m + Eigen::Vector3d(wobble_m, -wobble_m, 0.0));
    file << pose.timestamp_s << "," << at.latitude_deg << "," << at.longitude_deg << "," << at.height_m << ",0.5\n";
  }
  file.close();
  window().press(ui::ActionId::step_merge);
  window().settle();
  window().resize(1600, 1400);
  ASSERT_TRUE(window().click("merge/kind/gnss"));
  window().frames(2);
  ASSERT_TRUE(window().fill("merge/gnss_file", (folder_ / "track.csv").string()));
  window().settle();
  ASSERT_TRUE(model().status.placement);
  ASSERT_TRUE(model().status.placement->usable) << (model().status.placement->issues.empty() ? "" : to_string(model().status.placement->issues.front()));
  EXPECT_EQ(state().georeference.kind, GeoreferenceKind::none);  // shown, not yet done
  ASSERT_TRUE(window().click("merge/apply"));
  window().settle();
  ASSERT_EQ(state().georeference.kind, GeoreferenceKind::anchor);
  const Eigen::Vector3d there(20.0, 30.0, 0.0);
  const Geodetic is = geodetic_from_reference(state().georeference, there), should = geodetic_from_reference(somewhere(), there);
  EXPECT_NEAR(is.latitude_deg, should.latitude_deg, 5e-6);  // half a metre
  EXPECT_NEAR(is.longitude_deg, should.longitude_deg, 7e-6);
}

}  // namespace
}  // namespace stemwise
