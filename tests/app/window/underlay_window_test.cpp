#include <gtest/gtest.h>

#include "tests/app/window/window_fixture.hpp"
#include "tests/render/golden.hpp"

namespace stemwise {
namespace {

class UnderlayWindow : public WindowTest {
 protected:
  /// Points on a grid over the stems, in two heights.
  std::string write_cloud(const std::string& name) {
    Eigen::AlignedBox2d box;
    for (const ObservationRow& row : model().document.derived().tables.observations) box.extend(row.position_m.head<2>());
    std::string points;
    int count = 0;
    for (double x = box.min().x(); x < box.max().x(); x += 0.4)
      for (double y = box.min().y(); y < box.max().y(); y += 0.4)
        for (const double z : {0.0, 12.0}) {
          points += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
          ++count;
        }
    const fs::path path = folder_ / name;
    std::ofstream(path) << "ply\nformat ascii 1.0\nelement vertex " << count << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" << points;
    return path.string();
  }
  /// A portable picture of 4 x 4 pixels with a world file, as GDAL's AAIGrid: heights.
  std::string write_terrain(const std::string& name) {
    Eigen::AlignedBox2d box;
    for (const ObservationRow& row : model().document.derived().tables.observations) box.extend(row.position_m.head<2>());
    const fs::path path = folder_ / name;
    std::ofstream file(path);
    file << "ncols 20\nnrows 20\nxllcorner " << box.min().x() << "\nyllcorner " << box.min().y() << "\ncellsize " << box.sizes().maxCoeff() / 20.0 << "\n";
    for (int i = 0; i < 400; ++i) file << 5.0 * std::sin(i % 20) << ((i + 1) % 20 ? " " : "\n");
    return path.string();
  }
  void choose(const std::string& name) {
    window().press(ui::ActionId::file_underlay);
    window().frames(2);
    ASSERT_TRUE(window().click("files/entry/" + name));
    ASSERT_TRUE(window().click("files/accept"));
    window().settle();
  }
  render::Image picture() {
    window().frames(2);
    const std::string path = (folder_ / "seen.png").string();
    EXPECT_TRUE(window().screenshot(path));
    auto image = render::read_png(path);
    return image ? *image : render::Image{};
  }
  void open_layers() {
    if (!window().has("layers/links")) window().click("viewport/layers");
    window().frames(2);
  }
};

TEST_F(UnderlayWindow, ACloudIsOpenedSwitchedClippedAndTakenAway) {
  open_surveys();
  write_cloud("scan.ply");
  open_layers();
  const render::Image before = picture();
  window().press({ui::Key::escape});
  choose("scan.ply");
  ASSERT_EQ(model().view.underlays.size(), 1u);
  EXPECT_EQ(model().view.underlays[0].state, ui::Underlay::State::shown) << model().view.underlays[0].about;
  EXPECT_EQ(model().view.dialog, ui::Dialog::none);
  const std::string path = "underlay/" + std::to_string(model().view.underlays[0].id);
  const auto shown = [&] { return model().underlays.shown(model().view); };
  ASSERT_EQ(shown().size(), 1u);
  open_layers();
  const render::Image with = picture();
  EXPECT_GT(test::difference(with, before), 0.02);
  EXPECT_NE(window().value(path + "/about").find("points"), std::string::npos);
  ASSERT_TRUE(window().click(path));
  EXPECT_TRUE(shown().empty());
  ASSERT_TRUE(window().click(path));
  const ui::Rect slider = window().desk().registry().find(path + "/to")->rect;
  window().click_at(slider.x + 0.3f * slider.width, slider.center_y());
  ASSERT_EQ(shown().size(), 1u);
  EXPECT_LT(shown()[0].high_m, 20.0);
  EXPECT_GT(test::difference(picture(), with), 0.002);
  ASSERT_TRUE(window().click(path + "/remove"));
  window().settle();
  EXPECT_TRUE(model().view.underlays.empty());
  EXPECT_TRUE(model().notices.all().empty() || model().notices.all().front().severity == Severity::note);
}

TEST_F(UnderlayWindow, TheKeyHidesAllUnderlaysAndBringsThemBack) {
  open_surveys();
  const std::string cloud = write_cloud("scan.ply");
  window().desk().drop({cloud});
  window().settle();
  ASSERT_EQ(model().underlays.shown(model().view).size(), 1u);
  window().press(ui::ActionId::view_underlays);
  EXPECT_TRUE(model().underlays.shown(model().view).empty());
  window().press(ui::ActionId::view_underlays);
  EXPECT_EQ(model().underlays.shown(model().view).size(), 1u);
}

TEST_F(UnderlayWindow, UnderlaysAreThereAgainWhenTheProjectIsOpenedAgain) {
  open_surveys();
  write_terrain("ground.asc");
  const std::string cloud = write_cloud("scan.ply");
  choose("ground.asc");
  window().desk().drop({cloud});
  window().settle();
  ASSERT_EQ(model().view.underlays.size(), 2u);
  model().view.underlays[0].opacity = 0.5f;
  const fs::path project = folder_ / "stand.gpkg";
  model().document.set_path(project.string());
  window().press(ui::ActionId::file_save);
  window().settle();
  window_.reset();
  fs::remove(cloud);
  auto again = HeadlessWindow::create({.desk = {.paths = {project.string()}, .config_folder = (folder_ / "config").string()}});
  ASSERT_TRUE(again);
  window_ = std::move(*again);
  window().settle();
  ASSERT_EQ(model().view.underlays.size(), 2u);
  EXPECT_EQ(model().view.underlays[0].state, ui::Underlay::State::shown);
  EXPECT_NEAR(model().view.underlays[0].opacity, 0.5f, 1e-6);
  EXPECT_EQ(model().view.underlays[1].state, ui::Underlay::State::failed);
  ASSERT_FALSE(model().notices.all().empty());
  EXPECT_NE(model().notices.all().front().title.find("scan.ply"), std::string::npos);
}

TEST_F(UnderlayWindow, WhatCannotBeReadIsToldByNameWithHelp) {
  open_surveys();
  std::ofstream(folder_ / "broken.las") << "no cloud";
  std::ofstream(folder_ / "packed.laz") << "no cloud";
  std::ofstream(folder_ / "picture.png") << "no picture";
  for (const char* name : {"broken.las", "packed.laz", "picture.png"}) {
    model().notices.clear();
    window().desk().drop({(folder_ / name).string()});
    window().settle();
    EXPECT_TRUE(model().view.underlays.empty()) << name;
    ASSERT_FALSE(model().notices.all().empty()) << name;
    EXPECT_EQ(model().notices.all().front().severity, Severity::error);
    EXPECT_NE(model().notices.all().front().title.find(name), std::string::npos);
    ASSERT_FALSE(model().notices.all().front().details.empty());
    EXPECT_FALSE(model().notices.all().front().details.front().help.empty());
  }
}

TEST_F(UnderlayWindow, ACancelledReadingLeavesNothingBehind) {
  open_surveys();
  const std::string cloud = write_cloud("scan.ply");
  window().desk().drop({cloud});
  window().frame();
  model().jobs.cancel_all();
  window().settle();
  EXPECT_TRUE(model().view.underlays.empty() || model().view.underlays[0].state == ui::Underlay::State::shown);  // it may have been quicker
  window().desk().drop({cloud});
  window().settle();
  ASSERT_FALSE(model().view.underlays.empty());
  EXPECT_EQ(model().view.underlays.back().state, ui::Underlay::State::shown);
}

TEST_F(UnderlayWindow, AGeoreferenceMovesThemAndAnEmptyWindowRefusesThem) {
  window().desk().drop({(folder_ / "scan.ply").string()});
  window().frames(2);
  ASSERT_FALSE(model().notices.all().empty());
  EXPECT_TRUE(model().view.underlays.empty());
  model().notices.clear();
  open_surveys();
  const std::string cloud = write_cloud("scan.ply");
  window().desk().drop({cloud});
  window().settle();
  const auto first = model().underlays.shown(model().view).at(0).cloud;
  Georeference there;
  there.kind = GeoreferenceKind::crs;
  there.epsg = 32633;
  model().execute(set_georeference(there));
  window().settle();
  ASSERT_EQ(model().underlays.shown(model().view).size(), 1u);
  EXPECT_NE(model().underlays.shown(model().view)[0].cloud, first);  // read anew for the new place
}

}  // namespace
}  // namespace stemwise
