#include <gtest/gtest.h>
#include <unistd.h>

#include <sstream>

#include "app/platform/file_lock.hpp"
#include "app/window/requests.hpp"
#include "io/project_file.hpp"
#include "tests/app/window/window_fixture.hpp"

namespace stemwise {
namespace {

/// A saved project in the window, and somebody else who has it too.
class KeepTest : public WindowTest {
 protected:
  void save_project_with_surveys() {
    open_surveys();
    path_ = (folder_ / "stand.gpkg").string();
    model().document.set_path(path_);
    save();
    ASSERT_FALSE(model().document.is_dirty());
  }
  void save() {
    window().press(ui::ActionId::file_save);
    window().settle();
  }
  /// Another window, or a command, changes the file.
  void change_elsewhere(const std::string& title) {
    Result<ProjectState> read = read_project(path_);
    ASSERT_TRUE(read);
    Project project(std::move(*read));
    project.execute(set_title(title));
    ASSERT_TRUE(write_project(project.state(), path_));
  }
  void change_here(const std::string& title) {
    model().execute(set_title(title));
    window().settle();
  }
  static std::string title_in(const fs::path& path) {
    const auto read = read_project(path.string());
    return read ? read->title : "no project";
  }
  bool asks() { return model().view.dialog == ui::Dialog::question; }
  fs::path autosaves() const { return folder_ / "config" / "autosave"; }
  std::size_t kept_projects(const fs::path& folder) const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) count += entry.path().extension() == ".gpkg" ? 1 : 0;
    return count;
  }
  void start_again(const std::vector<std::string>& paths = {}) {
    auto again = HeadlessWindow::create({.desk = {.paths = paths, .config_folder = (folder_ / "config").string()}, .width = 1600, .height = 1000});
    ASSERT_TRUE(again);
    window_ = std::move(*again);
    window().settle();
  }
  /// What this window has kept, as a window would leave it that was killed: under this number, without a lock.
  void leave_behind(const std::string& number) {
    fs::create_directories(folder_ / "left");
    for (const auto& entry : fs::directory_iterator(autosaves())) {
      const std::string name = entry.path().filename().string();
      if (!name.ends_with(".lock")) fs::copy(entry.path(), folder_ / "left" / (number + name.substr(name.find('.'))));
    }
    window_.reset();  // takes its own away
    fs::remove_all(autosaves());
    fs::rename(folder_ / "left", autosaves());
  }

  std::string path_;
};

TEST_F(KeepTest, SavingOverWhatWasSavedElsewhereAsksAndACopyKeepsBoth) {
  save_project_with_surveys();
  change_elsewhere("theirs");
  change_here("ours");
  save();
  ASSERT_TRUE(asks());
  EXPECT_EQ(title_in(path_), "theirs");
  ASSERT_TRUE(window().click("question/no"));
  window().settle();
  EXPECT_TRUE(model().document.is_dirty());
  EXPECT_EQ(title_in(path_), "theirs");
  save();
  ASSERT_TRUE(asks());
  ASSERT_TRUE(window().click("question/other"));
  window().settle();
  EXPECT_EQ(title_in(path_), "theirs");
  EXPECT_EQ(title_in(folder_ / "stand-copy.gpkg"), "ours");
  EXPECT_EQ(model().document.path(), (folder_ / "stand-copy.gpkg").string());
  EXPECT_FALSE(model().document.is_dirty());
  change_here("ours again");
  save();
  EXPECT_FALSE(asks());
  EXPECT_EQ(title_in(folder_ / "stand-copy.gpkg"), "ours again");
}

TEST_F(KeepTest, ReplacingIsDoneOnlyWithWhatWasAskedAbout) {
  save_project_with_surveys();
  change_elsewhere("theirs");
  change_here("ours");
  save();
  ASSERT_TRUE(asks());
  change_elsewhere("theirs, later");
  ASSERT_TRUE(window().click("question/yes"));
  window().settle();
  ASSERT_TRUE(asks());  // that one was not meant
  EXPECT_EQ(title_in(path_), "theirs, later");
  ASSERT_TRUE(window().click("question/yes"));
  window().settle();
  EXPECT_EQ(title_in(path_), "ours");
  EXPECT_FALSE(model().document.is_dirty());
  change_here("ours, later");
  save();
  EXPECT_FALSE(asks());
  EXPECT_EQ(title_in(path_), "ours, later");
}

TEST_F(KeepTest, TheQuestionSaysHowManyEditsAreOnlyInTheFile) {
  save_project_with_surveys();
  align();
  save();
  const TreeId tree = state().trees.begin()->first;
  {
    Project project(*read_project(path_));
    project.execute(set_fate(tree, Fate::dead, {"other", "2026-11-28T07:00:00Z", ""}));
    ASSERT_TRUE(write_project(project.state(), path_));
  }
  model().execute(set_fate(tree, Fate::removed, stamp_now()));
  save();
  ASSERT_TRUE(asks());
  EXPECT_NE(model().status.question->text.find("1 edit that"), std::string::npos) << model().status.question->text;
  EXPECT_EQ(read_project(path_)->trees.at(tree).fate_by_hand, Fate::dead);
}

TEST_F(KeepTest, LeavingWithASaveThatIsNotDoneStays) {
  save_project_with_surveys();
  change_elsewhere("theirs");
  change_here("ours");
  window().press(ui::ActionId::file_quit);
  window().frames(2);
  ASSERT_TRUE(window().click("leave/save"));
  window().settle();
  ASSERT_TRUE(asks());
  EXPECT_FALSE(model().wants_close);
  ASSERT_TRUE(window().click("question/no"));
  window().settle();
  EXPECT_FALSE(model().wants_close);
  window().press(ui::ActionId::file_quit);
  window().frames(2);
  ASSERT_TRUE(window().click("leave/save"));
  window().settle();
  ASSERT_TRUE(window().click("question/other"));
  window().settle();
  EXPECT_TRUE(model().wants_close);
  EXPECT_EQ(title_in(folder_ / "stand-copy.gpkg"), "ours");
}

TEST_F(KeepTest, AProjectThatIsOpenInAnotherWindowIsSaidToBe) {
  save_project_with_surveys();
  auto other = platform::FileLock::take((autosaves() / "1.gpkg.lock").string());
  ASSERT_TRUE(other);
  other->write(path_);
  open_project(model(), path_);
  window().settle();
  ASSERT_FALSE(model().notices.all().empty());
  EXPECT_NE(model().notices.all().front().title.find("open in another window"), std::string::npos);
  other.reset();
  open_project(model(), path_);
  window().settle();
  EXPECT_TRUE(model().notices.all().empty());
}

TEST_F(KeepTest, AWindowSaysThatItsFileWasChangedElsewhereAndNotThatItSavedItself) {
  save_project_with_surveys();
  change_here("ours");
  save();
  model().notices.clear();
  window().frames(200);
  window().settle();
  EXPECT_TRUE(model().notices.all().empty());
  change_elsewhere("theirs");
  window().frames(200);
  window().settle();
  ASSERT_FALSE(model().notices.all().empty());
  const ui::Notice notice = model().notices.all().front();
  EXPECT_NE(notice.title.find("changed elsewhere"), std::string::npos);
  EXPECT_EQ(model().status.saved_text, "changed elsewhere");
  ASSERT_TRUE(window().click("toast/choice/" + std::to_string(notice.id) + "/Open it again"));
  window().settle();
  EXPECT_EQ(state().title, "theirs");
  EXPECT_NE(model().status.saved_text, "changed elsewhere");
}

TEST_F(KeepTest, RecoveryIsOfferedWhoeverHasTheNumberOfTheDeadWindowNow) {
  save_project_with_surveys();
  change_here("not saved");
  const ProjectState before = state();
  leave_behind("1");  // a process that always lives
  start_again();
  ASSERT_EQ(model().view.dialog, ui::Dialog::recover);
  ASSERT_TRUE(window().click("recover/yes"));
  window().settle();
  EXPECT_EQ(state(), before);
  EXPECT_EQ(kept_projects(autosaves()), 1u);
  leave_behind(std::to_string(::getpid()));  // our own number: must not be written over either
  start_again();
  ASSERT_EQ(model().view.dialog, ui::Dialog::recover);
  ASSERT_TRUE(window().click("recover/yes"));
  window().settle();
  EXPECT_EQ(state(), before);
  save();  // what it was brought back from is known: no question
  EXPECT_FALSE(asks());
  EXPECT_EQ(title_in(path_), "not saved");
  EXPECT_EQ(kept_projects(autosaves()), 0u);
}

TEST_F(KeepTest, WhatALivingWindowKeepsIsNotOffered) {
  save_project_with_surveys();
  change_here("not saved");
  leave_behind("77");
  auto living = platform::FileLock::take((autosaves() / "77.gpkg.lock").string());
  ASSERT_TRUE(living);
  start_again();
  EXPECT_EQ(model().view.dialog, ui::Dialog::none);
  living.reset();
  window_.reset();
  start_again();
  EXPECT_EQ(model().view.dialog, ui::Dialog::recover);
}

TEST_F(KeepTest, OpeningAProjectOffersWhatIsNotInItsFile) {
  save_project_with_surveys();
  change_here("not saved");
  leave_behind("1");
  start_again();
  ASSERT_TRUE(window().click("recover/later"));
  window().settle();
  EXPECT_EQ(kept_projects(autosaves()), 1u);
  ASSERT_TRUE(window().click("empty/recent/1"));
  window().settle();
  EXPECT_EQ(state().title, "");
  ASSERT_EQ(model().view.dialog, ui::Dialog::recover);
  window().press({ui::Key::escape});
  window().settle();
  EXPECT_EQ(model().view.dialog, ui::Dialog::none);
  EXPECT_EQ(kept_projects(autosaves()), 1u);
  fs::remove(path_);  // also when the file itself cannot be opened any more
  open_project(model(), path_);
  window().settle();
  ASSERT_EQ(model().view.dialog, ui::Dialog::recover);
  ASSERT_TRUE(window().click("recover/yes"));
  window().settle();
  EXPECT_EQ(state().title, "not saved");
  EXPECT_EQ(model().document.path(), path_);
}

TEST_F(KeepTest, RecoveredWorkOverAFileThatWasChangedSinceAsks) {
  save_project_with_surveys();
  change_here("not saved");
  leave_behind("1");
  change_elsewhere("theirs");
  start_again();
  EXPECT_NE(model().status.recovery_text.find("written again after"), std::string::npos) << model().status.recovery_text;
  ASSERT_TRUE(window().click("recover/yes"));
  window().settle();
  save();
  EXPECT_TRUE(asks());
  EXPECT_EQ(title_in(path_), "theirs");
}

TEST_F(KeepTest, AnotherProjectBeginsWithoutTheNoticesAndJobsOfTheOneBefore) {
  save_project_with_surveys();
  model().notices.add(Severity::warning, "of this project");
  ASSERT_GE(model().jobs.views().size(), 2u);
  open_project(model(), path_);
  window().settle();
  EXPECT_TRUE(model().notices.all().empty());
  EXPECT_EQ(model().jobs.views().size(), 1u);  // the opening itself
  model().notices.add(Severity::warning, "of this project");
  window().press(ui::ActionId::file_new);
  window().settle();
  EXPECT_TRUE(model().notices.all().empty());
  EXPECT_TRUE(model().jobs.views().empty());
}

TEST_F(KeepTest, AFolderThatIsNotThereIsNamed) {
  save_project_with_surveys();
  const std::string nowhere = (folder_ / "nowhere").string();
  const auto told = [&] {
    ASSERT_FALSE(model().notices.all().empty());
    EXPECT_NE(to_string(model().notices.all().front().details.front()).find("the folder " + nowhere + " is not there"), std::string::npos);
    model().notices.clear();
  };
  save_as(model(), nowhere + "/stand.gpkg");
  window().settle();
  told();
  export_layer(model(), {.path = nowhere + "/trees.gpkg", .layer = "trees"});
  window().settle();
  told();
  write_report(model(), {.path = nowhere + "/report.pdf"});
  window().settle();
  told();
  save_chart(model(), {ui::Chart::growth_distribution, nowhere + "/chart.png"});
  told();
}

TEST(NoticeList, TheSameOnceMoreTakesThePlaceOfTheEarlierOne) {
  NoticeList notices;
  notices.add(Severity::note, "Nothing left");
  notices.add(Severity::warning, "Another");
  notices.advance(5.0);
  notices.add(Severity::note, "Nothing left");
  ASSERT_EQ(notices.all().size(), 2u);
  EXPECT_EQ(notices.all().front().title, "Nothing left");
  EXPECT_EQ(notices.all().front().age_s, 0.0);
  notices.add(Severity::note, "Nothing left", {Issue{Severity::note, "a.csv", 0, "", "for another reason", ""}});
  EXPECT_EQ(notices.all().size(), 3u);
}

}  // namespace
}  // namespace stemwise
