#include <gtest/gtest.h>

#include "core/survey/field_check.hpp"
#include "core/survey/rule_pack.hpp"
#include "tests/app/window/window_fixture.hpp"

namespace stemwise {
namespace {

class ResultTest : public WindowTest {
 protected:
  void open_report() {
    open_surveys(300);
    align();
    window().press(ui::ActionId::step_report);
    window().settle();
  }
  const Tables& tables() { return model().document.derived().tables; }
};

TEST_F(ResultTest, EveryPackOfRulesSaysWhatItWouldFlagBeforeItIsChosen) {
  open_report();
  ASSERT_TRUE(window().click("report/open_rules"));
  window().settle();
  ASSERT_TRUE(model().status.rules);
  ASSERT_EQ(model().status.rules->packs.size(), rule_packs().size());
  int most = -1;
  std::string strictest;
  for (const ui::RulePreview& preview : model().status.rules->packs) {
    int broken = 0;
    for (const RuleCount& count : preview.counts) broken += count.broken;
    if (broken > most) {
      most = broken;
      strictest = preview.pack.name;
    }
  }
  for (const MatchRow& match : tables().matches) EXPECT_TRUE(match.flags.empty() || !chosen_rules(state()));
  const ProjectState before = state();
  ASSERT_TRUE(window().click("rules/" + strictest));
  window().settle();
  ASSERT_TRUE(chosen_rules(state()));
  const RulePack chosen = *chosen_rules(state());
  EXPECT_EQ(chosen.name, strictest);
  int flagged = 0;
  for (const MatchRow& match : tables().matches) {
    for (const Rule& rule : chosen.rules) flagged += std::count(match.flags.begin(), match.flags.end(), rule.flag) > 0 ? 1 : 0;
  }
  EXPECT_EQ(flagged, most);
  window().press(ui::ActionId::edit_undo);
  EXPECT_EQ(state(), before);
}

TEST_F(ResultTest, TheExportShowsItsRowsAndSystemAndRefusesWhatNeedsAPlaceOnTheEarth) {
  open_report();
  EXPECT_EQ(window().value("export/preview").find(std::to_string(tables().trees.size()) + " rows of "), 0u) << window().value("export/preview");
  EXPECT_NE(window().value("export/preview").find("local coordinates"), std::string::npos);
  ASSERT_TRUE(window().has("export/run"));
  ASSERT_TRUE(window().click("export/format"));
  window().frames(2);
  ASSERT_TRUE(window().click("export/format/KML (.kml)"));
  window().frames(2);
  EXPECT_FALSE(window().has("export/run"));
  ASSERT_TRUE(window().click("export/layer"));
  window().frames(2);
  ASSERT_TRUE(window().click("export/layer/Observations"));
  window().settle();
  EXPECT_EQ(window().value("export/preview").find(std::to_string(tables().observations.size()) + " rows of "), 0u);
}

TEST_F(ResultTest, TheReportSaysWhatWillBeInItForTheAreaThatIsGiven) {
  open_report();
  ASSERT_TRUE(model().status.reporting);
  EXPECT_GE(model().status.reporting->sections.size(), 5u);
  EXPECT_FALSE(model().status.reporting->figures.empty());
  ASSERT_TRUE(window().fill("report/area", "0.75"));
  window().settle();
  EXPECT_DOUBLE_EQ(model().status.reporting->area_ha, 0.75);
  const fs::path path = folder_ / "growth.html";
  ASSERT_TRUE(window().fill("report/path", path.string()));
  ASSERT_TRUE(window().click("report/run"));
  window().settle();
  EXPECT_GT(fs::file_size(path), 5000u);
}

TEST_F(ResultTest, ThePagesOfTheReportAreLookedAtBeforeItIsWritten) {
  open_report();
  window().press(ui::ActionId::export_preview_report);
  window().frames(3);
  window().settle();
  ASSERT_TRUE(model().status.page);
  const int pages = model().status.page->pages;
  ASSERT_GT(pages, 3);
  EXPECT_EQ(window().value("pages/where"), "Page 1 of " + std::to_string(pages));
  EXPECT_FALSE(window().has("pages/previous"));  // there is none before the first
  window().press({ui::Key::page_down});
  window().settle();
  EXPECT_EQ(window().value("pages/page"), "2");
  for (int page = 2; page < pages; ++page) ASSERT_TRUE(window().click("pages/next")) << page;
  window().settle();
  EXPECT_EQ(window().value("pages/page"), std::to_string(pages));
  EXPECT_FALSE(window().has("pages/next"));
  window().press({ui::Key::escape});
  window().frames(2);
  EXPECT_EQ(model().view.dialog, ui::Dialog::none);
  window().press(ui::ActionId::export_preview_field_check);
  window().frames(3);
  window().settle();
  EXPECT_EQ(model().status.page->form.sheet, ui::PrintedSheet::field_check);
  EXPECT_EQ(window().value("pages/page"), "1");
}

TEST_F(ResultTest, TheFieldCheckSheetIsWrittenWithAsManyTreesAsItSays) {
  open_report();
  ASSERT_TRUE(window().click("report/open_export"));  // folded away: the sheet stands at the foot
  ASSERT_TRUE(window().click("report/open_report"));
  window().frames(2);
  ASSERT_TRUE(window().click("report/open_check"));
  window().settle();
  const auto trees = make_field_check(state(), tables(), 100000).rows.size();
  ASSERT_GT(trees, 3u);
  ASSERT_TRUE(window().fill("check/most", "3"));
  window().settle();
  EXPECT_EQ(window().value("check/preview"), "3 trees of " + std::to_string(trees) + " that are in doubt and undecided");
  const fs::path path = folder_ / "check.csv";
  ASSERT_TRUE(window().fill("check/path", path.string()));
  ASSERT_TRUE(window().click("check/run"));
  window().settle();
  std::ifstream file(path);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_NE(text.find(tree_label(tables().queue.front().tree)), std::string::npos);
  ASSERT_TRUE(window().fill("check/path", (folder_ / "check.gpx").string()));
  window().frames(2);
  EXPECT_FALSE(window().has("check/run"));  // no place on the earth
}

}  // namespace
}  // namespace stemwise
