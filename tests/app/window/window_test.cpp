#include <gdal.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/window/headless_window.hpp"
#include "app/window/window_model.hpp"
#include "core/simulate/simulate_forest.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

void write_table(const fs::path& path, const Inventory& inventory) {
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

  void make_surveys() {
    SimulateSettings settings;
    settings.stems = 180;
    settings.seed = 3;
    settings.dates = {date_from_civil(2018, 7, 1), date_from_civil(2023, 7, 1)};
    const SimulatedForest forest = simulate_forest(settings);
    write_table(folder_ / "2018.csv", forest.surveys[0].inventory);
    write_table(folder_ / "2023.csv", forest.surveys[1].inventory);
  }

  HeadlessWindow& window() { return *window_; }
  WindowModel& model() { return window_->desk().model(); }
  const ProjectState& state() { return model().document.state(); }

  /// As a person does: Ctrl+I, the folder, the two files, Add.
  void open_surveys() {
    make_surveys();
    window().press(ui::ActionId::file_add);
    window().frames(2);
    ASSERT_TRUE(window().click("files/path"));
    window().press({ui::key('A'), true});
    window().type(folder_.string());
    window().press({ui::Key::enter});
    window().frames(2);
    ASSERT_TRUE(window().click("files/entry/2018.csv"));
    window().hold_ctrl(true);
    ASSERT_TRUE(window().click("files/entry/2023.csv"));
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

int feature_count(const std::string& path) {
  GDALAllRegister();
  const GDALDatasetH dataset = GDALOpenEx(path.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr);
  if (dataset == nullptr) return -1;
  const int count = static_cast<int>(OGR_L_GetFeatureCount(GDALDatasetGetLayer(dataset, 0), 1));
  GDALClose(dataset);
  return count;
}

TEST_F(WindowTest, AnEmptyWindowSaysWhatToDoAndOffersTheDemo) {
  EXPECT_TRUE(window().has("empty/add"));
  EXPECT_TRUE(window().has("empty/demo"));
  EXPECT_EQ(window().value("steps/1"), "none yet");
  ASSERT_TRUE(window().click("empty/demo"));
  window().settle();
  EXPECT_EQ(state().inventories.size(), 3u);
  EXPECT_EQ(window().value("steps/1"), "3 surveys");
}

TEST_F(WindowTest, TwoSurveysAreOpenedAlignedCorrectedAndExported) {
  open_surveys();
  ASSERT_EQ(state().inventories.size(), 2u);
  EXPECT_EQ(window().value("steps/1"), "2 surveys");
  align();
  EXPECT_EQ(window().value("steps/2"), "all aligned");
  const TreeId tree = lonely_matched_tree();
  ASSERT_TRUE(tree);

  click_in_map(tree);
  EXPECT_EQ(model().view.selected_tree, tree);
  EXPECT_EQ(window().value("review/tree"), tree_label(tree));

  const ProjectState before = state();
  window().press(ui::ActionId::review_unlink);
  window().settle();
  EXPECT_EQ(state().trees.at(tree).stems.size(), 1u);
  const StemRef taken_out = model().view.selected_stem;
  EXPECT_NE(state().tree_of(taken_out), tree);

  // Relink it: L, then a click on the other stem, with only the earlier survey shown.
  window().press(ui::ActionId::review_link);
  EXPECT_EQ(model().view.tool, ui::Tool::link);
  ASSERT_TRUE(window().click("view/compare/" + std::string(state().trees.at(tree).stems.front().inventory == model().document.derived().tables.inventories.front() ? "0" : "2")));
  window().settle();
  click_in_map(tree);
  window().settle();
  EXPECT_EQ(state().tree_of(taken_out), state().tree_of(before.trees.at(tree).stems.front()));

  window().press(ui::ActionId::edit_undo);
  window().press(ui::ActionId::edit_undo);
  window().settle();
  EXPECT_EQ(state(), before);

  window().press(ui::ActionId::step_report);
  window().frames(2);
  const std::string out = (folder_ / "trees.gpkg").string();
  ASSERT_TRUE(window().fill("export/path", out));
  ASSERT_TRUE(window().click("export/run"));
  window().settle();
  EXPECT_EQ(feature_count(out), static_cast<int>(model().document.derived().tables.trees.size()));
}

TEST_F(WindowTest, ABrokenFileIsANoticeAndNothingIsLost) {
  open_surveys();
  std::ofstream(folder_ / "broken.csv") << "";
  const ProjectState before = state();
  window().desk().drop({(folder_ / "broken.csv").string()});
  window().settle();
  EXPECT_EQ(state(), before);
  ASSERT_FALSE(model().notices.all().empty());
  EXPECT_EQ(model().notices.all().front().severity, Severity::error);
}

TEST_F(WindowTest, SavedAndOpenedAgainTheProjectIsTheSame) {
  open_surveys();
  align();
  const std::string path = (folder_ / "stand.gpkg").string();
  window().desk().model().document.set_path(path);
  window().press(ui::ActionId::file_save);
  window().settle();
  EXPECT_FALSE(model().document.is_dirty());
  const ProjectState saved = state();
  window().press(ui::ActionId::file_new);
  window().settle();
  EXPECT_TRUE(model().document.is_empty());
  ASSERT_TRUE(window().click("empty/recent/1"));
  window().settle();
  EXPECT_EQ(state(), saved);
}

TEST_F(WindowTest, UnsavedWorkSurvivesACrash) {
  open_surveys();
  window().settle();
  const ProjectState before = state();
  const fs::path kept = folder_ / "config" / "autosave";
  ASSERT_FALSE(fs::is_empty(kept));
  // As after a crash: the copy is there, its program is not.
  fs::copy(kept, folder_ / "copy");
  window_.reset();
  fs::create_directories(folder_ / "config2");
  fs::copy(folder_ / "copy", folder_ / "config2" / "autosave");
  for (const auto& entry : fs::directory_iterator(folder_ / "config2" / "autosave")) {
    if (entry.path().extension() == ".json") std::ofstream(entry.path()) << R"({"path": "", "title": "Stand", "time": "", "process": 2147483000})";
  }
  auto again = HeadlessWindow::create({.desk = {.paths = {}, .config_folder = (folder_ / "config2").string()}});
  ASSERT_TRUE(again);
  window_ = std::move(*again);
  window().frames(3);
  ASSERT_TRUE(window().click("recover/yes"));
  window().settle();
  EXPECT_EQ(state(), before);
  EXPECT_TRUE(model().document.is_dirty());
}

TEST_F(WindowTest, PanelsDoNotOverlapAtTheSmallestSize) {
  window().desk().drop({});
  ASSERT_TRUE(window().click("empty/demo"));
  window().settle();
  window().resize(1280, 720);
  const ui::WidgetRegistry& widgets = window().desk().registry();
  std::vector<std::pair<std::string, ui::Rect>> buttons;
  for (const auto& [path, entry] : widgets.entries()) {
    if (entry.visible && (path.starts_with("steps/") || path.starts_with("tabs/") || path.starts_with("viewport/"))) buttons.emplace_back(path, entry.rect);
  }
  ASSERT_GE(buttons.size(), 14u);
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    EXPECT_GE(buttons[i].second.x, 0.0f) << buttons[i].first;
    EXPECT_LE(buttons[i].second.right(), 1280.0f) << buttons[i].first;
    for (std::size_t k = i + 1; k < buttons.size(); ++k) {
      if (buttons[i].first == "viewport/tree" || buttons[k].first == "viewport/tree" || buttons[i].first == "viewport/hover" || buttons[k].first == "viewport/hover") continue;
      EXPECT_FALSE(buttons[i].second.overlaps(buttons[k].second)) << buttons[i].first << " over " << buttons[k].first;
    }
  }
}

TEST_F(WindowTest, EveryActionIsInAMenuWithItsReasonWhenGreyedOut) {
  for (const char* menu : {"File", "Edit", "View", "Align", "Review", "Export", "Help"}) {
    ASSERT_TRUE(window().click(std::string("menu/") + menu)) << menu;
    for (const ui::Action& a : ui::all_actions()) {
      if (std::string(ui::menu_label(a.menu)) != menu) continue;
      EXPECT_NE(window().desk().registry().find(std::string("menu/") + a.name), nullptr) << a.name;
    }
    window().press({ui::Key::escape});
    window().frames(2);
  }
}

TEST_F(WindowTest, ThePaletteRunsWhatIsTyped) {
  window().press(ui::ActionId::help_palette);
  window().frames(3);
  window().type("dark theme");
  window().press({ui::Key::enter});
  window().frames(2);
  EXPECT_EQ(model().view.theme, ui::ThemeName::dark);
}

}  // namespace
}  // namespace stemwise
