#include <gtest/gtest.h>

#include <sstream>

#include "app/platform/folders.hpp"
#include "app/window/requests.hpp"
#include "io/project_file.hpp"
#include "tests/app/window/window_fixture.hpp"
#include "ui/frame.hpp"

namespace stemwise {
namespace {

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST_F(WindowTest, AnExportOrReportNeverDestroysAProject) {
  open_surveys();
  const fs::path own = folder_ / "stand.gpkg", other = folder_ / "other.gpkg";
  for (const fs::path& path : {other, own}) {
    model().document.set_path(path.string());
    window().press(ui::ActionId::file_save);
    window().settle();
  }
  const std::string own_before = content(own), other_before = content(other);
  ASSERT_FALSE(own_before.empty());
  window().press(ui::ActionId::step_report);
  window().frames(2);
  for (const fs::path& path : {own, other}) {
    model().notices.clear();
    ASSERT_TRUE(window().fill("export/path", path.string()));
    ASSERT_TRUE(window().click("export/run"));
    window().settle();
    ASSERT_FALSE(model().notices.all().empty());
    EXPECT_EQ(model().notices.all().front().severity, Severity::error);
    EXPECT_NE(model().notices.all().front().title.find(path.filename().string()), std::string::npos);
    EXPECT_EQ(model().view.dialog, ui::Dialog::none);
  }
  model().notices.clear();
  ASSERT_TRUE(window().fill("report/path", own.string()));
  ASSERT_TRUE(window().click("report/run"));
  window().settle();
  ASSERT_FALSE(model().notices.all().empty());
  EXPECT_EQ(content(own), own_before);
  EXPECT_EQ(content(other), other_before);
}

TEST_F(WindowTest, AnExportOverAnotherFileAsksFirst) {
  open_surveys();
  const fs::path path = folder_ / "notes.csv";
  std::ofstream(path) << "my own notes\n";
  window().press(ui::ActionId::step_report);
  window().frames(2);
  ASSERT_TRUE(window().fill("export/path", path.string()));
  ASSERT_TRUE(window().click("export/run"));
  window().settle();
  ASSERT_EQ(model().view.dialog, ui::Dialog::question);
  ASSERT_TRUE(window().click("question/no"));
  window().settle();
  EXPECT_EQ(content(path), "my own notes\n");
  EXPECT_EQ(model().view.dialog, ui::Dialog::none);
  ASSERT_TRUE(window().click("export/run"));
  window().settle();
  ASSERT_TRUE(window().click("question/yes"));
  window().settle();
  EXPECT_NE(content(path).find("tree_id"), std::string::npos);
}

TEST_F(WindowTest, SurveysAreCalledByTheirYearOnlyWhenEachHasItsOwn) {
  make_surveys();
  fs::copy(folder_ / "2018.csv", folder_ / "bad.csv");
  window().desk().drop({(folder_ / "bad.csv").string(), (folder_ / "2023.csv").string()});
  window().settle();
  ASSERT_EQ(state().inventories.size(), 2u);
  const InventoryId bad = state().inventories[0]->id, later = state().inventories[1]->id;
  model().execute(set_inventory_date(bad, date_from_civil(2018, 7, 1)));
  model().execute(set_inventory_date(later, date_from_civil(2023, 7, 1)));
  EXPECT_EQ(ui::survey_label(state(), bad), "2018");
  model().execute(set_inventory_date(later, date_from_civil(2018, 8, 1)));
  EXPECT_EQ(ui::survey_label(state(), bad), "bad");
  model().execute(set_inventory_date(later, std::nullopt));
  EXPECT_EQ(ui::survey_label(state(), bad), "bad");
  EXPECT_EQ(ui::survey_label(state(), later), "2023");
}

TEST_F(WindowTest, ThrowingUnsavedWorkAwayAsksAndCanBeTakenBack) {
  open_surveys();
  const fs::path kept = folder_ / "config" / "autosave";
  ASSERT_FALSE(fs::is_empty(kept));
  fs::create_directories(folder_ / "config2");
  fs::copy(kept, folder_ / "config2" / "autosave");
  window_.reset();
  const auto count = [&] {
    const auto is_kept = [](const auto& entry) { return entry.path().extension() != ".lock"; };
    return std::count_if(fs::directory_iterator(folder_ / "config2" / "autosave"), fs::directory_iterator(), is_kept);
  };
  for (const auto& entry : fs::directory_iterator(folder_ / "config2" / "autosave")) {
    if (entry.path().extension() == ".json") std::ofstream(entry.path()) << R"({"path": "", "title": "Stand", "time": "2026-11-22T05:00:30Z"})";
  }
  const auto before = count();
  auto again = HeadlessWindow::create({.desk = {.paths = {}, .config_folder = (folder_ / "config2").string()}});
  ASSERT_TRUE(again);
  window_ = std::move(*again);
  window().frames(3);
  EXPECT_NE(model().status.recovery_text.find(platform::local_time("2026-11-22T05:00:30Z")), std::string::npos);
  ASSERT_TRUE(window().click("recover/no"));
  window().frames(3);
  EXPECT_EQ(model().view.dialog, ui::Dialog::question);
  EXPECT_EQ(count(), before);
  ASSERT_TRUE(window().click("question/no"));
  window().frames(3);
  EXPECT_EQ(model().view.dialog, ui::Dialog::recover);
  ASSERT_TRUE(window().click("recover/no"));
  window().frames(3);
  ASSERT_TRUE(window().click("question/yes"));
  window().frames(3);
  EXPECT_EQ(count(), 0);
}

TEST_F(WindowTest, QuitWorksWhileADialogIsOpenAndSavesFirstWhereThatIsNeeded) {
  for (const ui::ActionId opens : {ui::ActionId::help_palette, ui::ActionId::file_open, ui::ActionId::help_about}) {
    run_action(model(), opens);
    window().frames(3);
    ASSERT_NE(model().view.dialog, ui::Dialog::none);
    window().press(ui::ActionId::file_quit);
    window().frames(3);
    EXPECT_TRUE(model().wants_close);
    EXPECT_EQ(model().view.dialog, ui::Dialog::none);
    model().wants_close = false;
  }
  open_surveys();
  window().press(ui::ActionId::help_palette);
  window().frames(2);
  window().press(ui::ActionId::file_quit);
  window().frames(3);
  EXPECT_FALSE(model().wants_close);
  EXPECT_EQ(model().view.dialog, ui::Dialog::leave);
  window().press(ui::ActionId::file_quit);
  window().frames(3);
  EXPECT_EQ(model().view.dialog, ui::Dialog::leave);
  ASSERT_TRUE(window().click("leave/discard"));
  window().frames(2);
  EXPECT_TRUE(model().wants_close);
}

TEST_F(WindowTest, TheFileDialogTakesAPathAtOnceAndNamesAFolderOnce) {
  make_surveys();
  model().status.home_folder = folder_.string();
  fs::create_directory_symlink(folder_, folder_ / "again");
  model().preferences.working_folder = (folder_ / "again").string() + "/";
  window().press(ui::ActionId::file_add);
  window().frames(4);
  EXPECT_EQ(window().desk().focused(), "files/path");
  int places = 0;
  for (const auto& [path, entry] : window().desk().registry().entries()) places += path.starts_with("files/place/") ? 1 : 0;
  EXPECT_EQ(places, 2);  // Home and Computer
  window().press({ui::key('A'), true});
  window().type((folder_ / "2018.csv").string());
  window().press({ui::Key::enter});
  window().settle();
  EXPECT_EQ(state().inventories.size(), 1u);
  window().press(ui::ActionId::file_save_as);
  window().frames(4);
  EXPECT_EQ(window().desk().focused(), "files/name");
  window().press({ui::key('A'), true});
  window().type("stand");
  window().press({ui::Key::enter});
  window().settle();
  EXPECT_TRUE(fs::exists(folder_ / "stand.gpkg"));
  EXPECT_EQ(model().view.dialog, ui::Dialog::none);
}

TEST_F(WindowTest, SavingUnderANameThatAnotherProjectHasAsksAlsoWhenTheSuffixWasNotTyped) {
  open_surveys();
  ASSERT_TRUE(write_project(ProjectState{}, (folder_ / "victim.gpkg").string()));
  const auto before = fs::last_write_time(folder_ / "victim.gpkg");
  window().press(ui::ActionId::file_save_as);
  window().frames(3);
  ASSERT_TRUE(window().fill("files/name", "victim"));
  window().frames(2);
  EXPECT_EQ(window().value("files/as"), "victim.gpkg is there already");
  ASSERT_TRUE(window().click("files/accept"));
  window().settle();
  ASSERT_EQ(model().view.dialog, ui::Dialog::question);
  ASSERT_TRUE(window().click("question/no"));
  window().settle();
  EXPECT_EQ(fs::last_write_time(folder_ / "victim.gpkg"), before);
  EXPECT_TRUE(model().document.path().empty());
  save_as(model(), (folder_ / "victim.gpkg").string());
  window().frames(3);
  ASSERT_TRUE(window().click("question/yes"));
  window().settle();
  EXPECT_EQ(read_project((folder_ / "victim.gpkg").string()).value, state());
}

}  // namespace
}  // namespace stemwise
