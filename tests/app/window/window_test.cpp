#include <gdal.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/app/window/window_fixture.hpp"

namespace stemwise {
namespace {

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

class CrashTest : public WindowTest {
 protected:
  /// As after a crash: the copy is there, its program is not. Another window begins, with these files.
  void crash_and_begin_again(const std::string& path_of_project, std::vector<std::string> opens) {
    const fs::path kept = folder_ / "config" / "autosave", copy = folder_ / "config2" / "autosave";
    ASSERT_FALSE(fs::is_empty(kept));
    fs::copy(kept, folder_ / "copy");
    window_.reset();
    fs::create_directories(copy.parent_path());
    fs::copy(folder_ / "copy", copy);
    for (const auto& entry : fs::directory_iterator(copy)) {
      if (entry.path().extension() == ".json") std::ofstream(entry.path()) << R"({"path": ")" << path_of_project << R"(", "title": "Stand", "time": ""})";
    }
    auto again = HeadlessWindow::create({.desk = {.paths = std::move(opens), .config_folder = (folder_ / "config2").string()}});
    ASSERT_TRUE(again);
    window_ = std::move(*again);
  }
};

TEST_F(CrashTest, UnsavedWorkSurvivesACrash) {
  open_surveys();
  window().settle();
  const ProjectState before = state();
  crash_and_begin_again("", {});
  window().frames(3);
  ASSERT_TRUE(window().click("recover/yes"));
  window().settle();
  EXPECT_EQ(state(), before);
  EXPECT_TRUE(model().document.is_dirty());
}

TEST_F(CrashTest, UnsavedWorkOfAProjectIsOfferedWhenThatProjectIsOpened) {
  open_surveys();
  const std::string path = (folder_ / "stand.gpkg").string();
  window().desk().model().document.set_path(path);
  window().press(ui::ActionId::file_save);
  window().settle();
  model().execute(set_title("changed since"));
  window().settle();
  const ProjectState before = state();
  const fs::path here = fs::current_path();
  fs::current_path(folder_);
  crash_and_begin_again(path, {"stand.gpkg"});
  fs::current_path(here);
  window().settle();
  EXPECT_EQ(model().document.path(), path);
  ASSERT_TRUE(window().click("recover/yes"));
  window().settle();
  EXPECT_EQ(state(), before);
  EXPECT_TRUE(model().document.is_dirty());
  EXPECT_EQ(model().document.path(), path);
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
