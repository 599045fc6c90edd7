#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "app/window/headless_window.hpp"
#include "app/window/window_model.hpp"
#include "core/project/commands.hpp"
#include "core/simulate/simulate_forest.hpp"

namespace stemwise {

namespace fs = std::filesystem;

inline void write_table(const fs::path& path, const Inventory& inventory) {
  std::ofstream file(path);
  file << "id,x_m,y_m,z_m,dbh_cm,species\n";
  file.precision(10);
  for (const Stem& s : inventory.stems) {
    file << s.source_id << "," << s.x_m << "," << s.y_m << "," << s.z_m.value_or(0.0) << ",";
    if (s.dbh_m) file << *s.dbh_m * 100.0;
    file << "," << s.species << "\n";
  }
}

/// A folder with two surveys of one small forest, and a window to work in.
class WindowTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) / ("window-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    auto window = HeadlessWindow::create({.desk = {.paths = {}, .config_folder = (folder_ / "config").string()}, .width = 1600, .height = 1000});
    if (!window) GTEST_SKIP() << "SKIPPED: no EGL surfaceless context here: " << to_string(window.issues.front());
    window_ = std::move(*window);
  }
  void TearDown() override {
    window_.reset();
    fs::remove_all(folder_);
  }

  void make_surveys(int stems = 180, const std::vector<int>& years = {2018, 2023}) {
    SimulateSettings settings;
    settings.stems = stems;
    settings.seed = 3;
    settings.dates.clear();
    for (const int year : years) settings.dates.push_back(date_from_civil(year, 7, 1));
    const SimulatedForest forest = simulate_forest(settings);
    for (std::size_t i = 0; i < years.size(); ++i) write_table(folder_ / (std::to_string(years[i]) + ".csv"), forest.surveys[i].inventory);
  }

  HeadlessWindow& window() { return *window_; }
  WindowModel& model() { return window_->desk().model(); }
  const ProjectState& state() { return model().document.state(); }

  /// As a person does: Ctrl+I, the folder, the files, Add.
  void open_surveys(int stems = 180, const std::vector<int>& years = {2018, 2023}) {
    make_surveys(stems, years);
    window().press(ui::ActionId::file_add);
    window().frames(2);
    ASSERT_TRUE(window().click("files/path"));
    window().press({ui::key('A'), true});
    window().type(folder_.string());
    window().press({ui::Key::enter});
    window().frames(2);
    for (const int year : years) {
      window().hold_ctrl(year != years.front());
      ASSERT_TRUE(window().click("files/entry/" + std::to_string(year) + ".csv"));
    }
    window().hold_ctrl(false);
    ASSERT_TRUE(window().click("files/accept"));
    window().settle();
  }

  void align() {
    window().press(ui::ActionId::step_align);
    ASSERT_TRUE(window().click("align/run"));
    window().settle();
  }

  /// A tree seen twice that stands alone, so that a click can mean nothing else.
  TreeId lonely_matched_tree() {
    const render::Viewport& viewport = model().viewport.viewport();
    const Tables& tables = model().document.derived().tables;
    for (const TreeRow& tree : tables.trees) {
      const auto at = viewport.pixels_of(tree.tree);
      if (tree.times_seen != 2 || !at || at->x() < 300 || at->x() > 800 || at->y() < 120 || at->y() > 480) continue;
      const bool alone = std::none_of(tables.trees.begin(), tables.trees.end(), [&](const TreeRow& other) {
        return other.tree != tree.tree && (other.position_m - tree.position_m).head<2>().norm() < 2.0;
      });
      if (alone) return tree.tree;
    }
    return {};
  }

  void click_in_map(TreeId tree) {
    const auto at = model().viewport.viewport().pixels_of(tree);
    ASSERT_TRUE(at);
    const ui::Rect map = window().desk().registry().find("viewport")->rect;
    window().click_at(map.x + static_cast<float>(at->x()), map.y + static_cast<float>(at->y()));
  }

  fs::path folder_;
  std::unique_ptr<HeadlessWindow> window_;
};

}  // namespace stemwise
