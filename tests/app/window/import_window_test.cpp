#include <gtest/gtest.h>

#include "app/window/import_memory.hpp"
#include "app/window/requests.hpp"
#include "tests/app/window/window_fixture.hpp"

namespace stemwise {
namespace {

class ImportTest : public WindowTest {
 protected:
  fs::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  /// Forty stems of 8 to 16 without a unit.
  fs::path write_plain(const std::string& name, const std::string& header = "x,y,dbh") {
    std::string text = header + "\n";
    for (int i = 0; i < 40; ++i) text += std::to_string(i % 8 * 3) + "," + std::to_string(i / 8 * 4) + "," + std::to_string(8 + i % 9) + "\n";
    return write(name, text);
  }
  void drop(const std::vector<fs::path>& paths) {
    std::vector<std::string> names;
    for (const fs::path& path : paths) names.push_back(path.string());
    window().desk().drop(names);
    window().settle();
  }
  bool is_open() { return model().view.dialog == ui::Dialog::import; }
  bool choose(const std::string& combo, const std::string& item) {
    if (!window().click(combo)) return false;
    window().frames(2);
    const bool done = window().click(combo + "/" + item);
    window().settle();
    return done;
  }
  const ui::ImportFile& file(std::size_t i = 0) { return model().status.imports.at(i); }
};

TEST_F(ImportTest, ACleanFileIsTakenWithoutADialog) {
  make_surveys();
  drop({folder_ / "2018.csv"});
  EXPECT_FALSE(is_open());
  EXPECT_EQ(state().inventories.size(), 1u);
}

TEST_F(ImportTest, AGuessedUnitOpensTheDialogAndAnotherUnitIsReadAtOnce) {
  drop({write_plain("plain.csv")});
  ASSERT_TRUE(is_open());
  EXPECT_TRUE(state().inventories.empty());
  ASSERT_EQ(file().stems.size(), 40u);
  const double cm = *file().stems.front().dbh_m;
  EXPECT_TRUE(window().has("import/guessed/dbh"));
  EXPECT_EQ(window().value("import/unit/dbh"), "cm");
  ASSERT_TRUE(choose("import/unit/dbh", "inch"));
  EXPECT_NEAR(*file().stems.front().dbh_m, 2.54 * cm, 1e-9);
  EXPECT_FALSE(window().has("import/guessed/dbh"));
  EXPECT_EQ(window().value("import/problems"), "0");
  EXPECT_EQ(file().command_line, "--unit dbh=in");
  ASSERT_TRUE(window().click("import/add"));
  window().settle();
  ASSERT_EQ(state().inventories.size(), 1u);
  EXPECT_NEAR(*state().inventories.front()->stems.front().dbh_m, 2.54 * cm, 1e-9);
  EXPECT_EQ(state().inventories.front()->name, "plain");
  window().press(ui::ActionId::edit_undo);
  EXPECT_TRUE(state().inventories.empty());
}

TEST_F(ImportTest, AMappingIsRememberedForTheNextFileWithThisHeaderAlsoInAnotherWindow) {
  drop({write_plain("first.csv")});
  ASSERT_TRUE(choose("import/unit/dbh", "mm"));
  ASSERT_TRUE(window().click("import/add"));
  window().settle();
  window_.reset();
  auto again = HeadlessWindow::create({.desk = {.paths = {}, .config_folder = (folder_ / "config").string()}});
  ASSERT_TRUE(again);
  window_ = std::move(*again);
  drop({write_plain("second.csv")});
  EXPECT_FALSE(is_open());
  ASSERT_EQ(state().inventories.size(), 1u);
  EXPECT_LT(*state().inventories.front()->stems.front().dbh_m, 0.02);
  drop({write_plain("other.csv", "x,y,d")});  // another header: asked anew
  EXPECT_TRUE(is_open());
}

TEST_F(ImportTest, ColumnsNobodyRecognisesAreChosenByHand) {
  std::string text = "kx;ky;paksuus\n";
  for (int i = 0; i < 30; ++i) text += std::to_string(i % 6 * 2) + ".5;" + std::to_string(i / 6 * 3) + ".25;" + std::to_string(120 + i) + "\n";
  drop({write("metsa.csv", text)});
  ASSERT_TRUE(is_open());
  EXPECT_FALSE(file().usable);
  ASSERT_EQ(file().header.size(), 3u);
  EXPECT_FALSE(window().has("import/add"));
  ASSERT_TRUE(choose("import/column/x", "kx"));
  ASSERT_TRUE(choose("import/column/y", "ky"));
  EXPECT_TRUE(file().usable);
  ASSERT_TRUE(choose("import/column/dbh", "paksuus"));
  ASSERT_TRUE(choose("import/unit/dbh", "mm"));
  EXPECT_NEAR(*file().stems.front().dbh_m, 0.12, 1e-12);
  ASSERT_TRUE(window().click("import/add"));
  window().settle();
  ASSERT_EQ(state().inventories.size(), 1u);
  EXPECT_EQ(state().inventories.front()->stems.size(), 30u);
}

TEST_F(ImportTest, BadRowsAreListedAndFilesThatCannotBeReadAreLeftOut) {
  make_surveys();
  drop({folder_ / "2018.csv", write("empty.csv", ""), write("words.csv", "x_m,y_m,dbh_cm\n1,2,3\nhere,5,6\n"), write("nothing.csv", "x_m,y_m,dbh_cm\nhere,there,6\n")});
  ASSERT_TRUE(is_open());
  ASSERT_EQ(model().status.imports.size(), 4u);
  EXPECT_FALSE(file(1).usable);
  EXPECT_FALSE(file(3).usable);
  const auto names_row = [](const Issue& issue) { return issue.row == 3 && issue.column == "x_m"; };
  EXPECT_TRUE(std::any_of(file(2).issues.begin(), file(2).issues.end(), names_row));
  ASSERT_TRUE(window().click("import/file/2"));
  window().frames(2);
  EXPECT_EQ(window().value("import/problems"), "1");
  EXPECT_EQ(window().value("import/problem/row/0"), "3");
  ASSERT_TRUE(window().click("import/add"));
  window().settle();
  EXPECT_EQ(state().inventories.size(), 2u);
}

TEST_F(ImportTest, AFileCanBeLeftOutAndCancelTakesNothing) {
  drop({write_plain("a.csv"), write_plain("b.csv")});
  ASSERT_TRUE(is_open());
  ASSERT_TRUE(window().click("import/take"));
  EXPECT_EQ(window().value("import/add"), "Add 1 inventory");
  ASSERT_TRUE(window().click("import/cancel"));
  window().settle();
  EXPECT_FALSE(is_open());
  EXPECT_TRUE(state().inventories.empty());
}

TEST_F(ImportTest, StatusCodesDateNameAndSystemAreAsThePersonSays) {
  write("codes.csv", "x_m,y_m,dbh_cm,status\n500001,5400001,10,K\n500004,5400002,12,Q\n500009,5400007,14,K\n");
  add_inventories(model(), {(folder_ / "codes.csv").string()}, true);
  window().settle();
  ASSERT_TRUE(is_open());
  ASSERT_TRUE(choose("import/code/Q", "dead"));
  ASSERT_TRUE(window().fill("import/name", "Lower plot"));
  ASSERT_TRUE(window().fill("import/date", "2021-06-30"));
  window().settle();
  ASSERT_TRUE(window().fill("import/epsg", "25832"));
  window().settle();
  ASSERT_TRUE(window().click("import/add"));
  window().settle();
  ASSERT_EQ(state().inventories.size(), 1u);
  const Inventory& inventory = *state().inventories.front();
  EXPECT_EQ(inventory.name, "Lower plot");
  EXPECT_EQ(inventory.date, date_from_civil(2021, 6, 30));
  EXPECT_EQ(inventory.source.epsg, 25832);
  EXPECT_EQ(inventory.stems.at(1).status, StemStatus::dead);
  EXPECT_EQ(inventory.stems.at(0).status, StemStatus::unknown);
  EXPECT_DOUBLE_EQ(inventory.stems.at(0).x_m, 500001.0);
}

TEST_F(ImportTest, EscapeInAListOfTheDialogClosesTheListOnly) {
  drop({write_plain("plain.csv")});
  ASSERT_TRUE(window().click("import/unit/dbh"));
  window().frames(2);
  ASSERT_TRUE(window().has("import/unit/dbh/mm"));
  window().press({ui::Key::escape});
  EXPECT_TRUE(is_open());
  EXPECT_FALSE(window().has("import/unit/dbh/mm"));
  window().press({ui::Key::escape});
  EXPECT_FALSE(is_open());
}

TEST_F(ImportTest, EveryMessyFileIsShownAsItWillBeUnderstood) {
  const char* data = std::getenv("STEMWISE_SHARED_DATA");
  const fs::path messy = fs::path(data != nullptr ? data : STEMWISE_SOURCE_DIR "/../shared/data") / "messy";
  if (!fs::is_directory(messy)) GTEST_SKIP() << "SKIPPED: no messy data at " << messy;
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(messy)) {
    if (entry.path().extension() != ".md") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  drop(paths);
  ASSERT_TRUE(is_open());
  for (const ui::ImportFile& file : model().status.imports) {
    EXPECT_FALSE(file.header.empty()) << file.file_name;
    if (!file.usable) continue;
    EXPECT_FALSE(file.stems.empty()) << file.file_name;
    EXPECT_GE(file.columns.size(), 2u) << file.file_name;
  }
}

TEST(ImportMemory, KeepsTheNewestMappingOfAHeaderAndForgetsWhatSaysNothing) {
  const fs::path path = fs::path(::testing::TempDir()) / "import-memory.json";
  fs::remove(path);
  ImportMemory memory = ImportMemory::read(path.string());
  ReadOptions options;
  options.units["dbh"] = "mm";
  options.status_codes["K"] = StemStatus::dead;
  options.plot = "4";
  memory.remember({"x", "y", "dbh"}, options);
  const auto found = ImportMemory::read(path.string()).find({"x", "y", "dbh"});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->units, options.units);
  EXPECT_EQ(found->status_codes, options.status_codes);
  EXPECT_TRUE(found->plot.empty());
  EXPECT_FALSE(memory.find({"x", "y"}));
  memory.remember({"x", "y", "dbh"}, {});
  EXPECT_EQ(ImportMemory::read(path.string()).size(), 0u);
  std::ofstream(path) << "broken";
  EXPECT_EQ(ImportMemory::read(path.string()).size(), 0u);
}

TEST_F(ImportTest, ADateThatIsNoneStaysInItsFieldAndIsNotTakenForOne) {
  drop({write_plain("a.csv"), write_plain("b.csv")});
  ASSERT_TRUE(is_open());
  ASSERT_TRUE(window().fill("import/date", "June 2020"));
  window().settle();
  EXPECT_TRUE(window().has("import/date/refused"));
  EXPECT_FALSE(window().has("import/add"));
  ASSERT_TRUE(window().fill("import/name", "other"));
  ASSERT_TRUE(choose("import/unit/dbh", "inch"));
  ASSERT_TRUE(window().click("import/file/1"));
  window().settle();
  EXPECT_EQ(window().value("import/date"), "");
  EXPECT_FALSE(window().has("import/date/refused"));
  EXPECT_FALSE(window().has("import/add"));  // it would be taken without the date that was meant
  ASSERT_TRUE(window().click("import/file/0"));
  window().settle();
  EXPECT_EQ(window().value("import/date"), "June 2020");
  EXPECT_TRUE(window().has("import/date/refused"));
  ASSERT_TRUE(window().fill("import/date", "2020-06-15"));
  window().settle();
  EXPECT_FALSE(window().has("import/date/refused"));
  ASSERT_TRUE(window().click("import/add"));
  window().settle();
  ASSERT_EQ(state().inventories.size(), 2u);
  EXPECT_EQ(state().inventories.front()->date, date_from_civil(2020, 6, 15));
}

TEST_F(ImportTest, ADateOfASurveyThatIsNoneStaysInItsField) {
  make_surveys();
  drop({folder_ / "2018.csv", folder_ / "2023.csv"});
  ASSERT_EQ(state().inventories.size(), 2u);
  ASSERT_TRUE(window().fill("details/date", "2023-13-45"));
  window().settle();
  EXPECT_TRUE(window().has("details/date/refused"));
  const InventoryId first = model().view.selected_inventory;
  model().execute(set_title("something else"));
  window().settle();
  EXPECT_EQ(window().value("details/date"), "2023-13-45");
  model().view.selected_inventory = state().inventories[state().inventories[0]->id == first ? 1 : 0]->id;
  window().settle();
  EXPECT_FALSE(window().has("details/date/refused"));
  model().view.selected_inventory = first;
  window().settle();
  EXPECT_EQ(window().value("details/date"), "2023-13-45");
  EXPECT_TRUE(window().has("details/date/refused"));
  ASSERT_TRUE(window().fill("details/date", "2023-12-24"));
  window().settle();
  EXPECT_FALSE(window().has("details/date/refused"));
  EXPECT_EQ(state().find(first)->date, date_from_civil(2023, 12, 24));
}

TEST_F(ImportTest, ACancelledImportThatWasEditedCanBeHadBack) {
  drop({write_plain("plain.csv")});
  ASSERT_TRUE(is_open());
  window().press({ui::Key::escape});
  window().settle();
  EXPECT_TRUE(model().notices.all().empty());  // nothing to lose
  drop({folder_ / "plain.csv"});
  ASSERT_TRUE(choose("import/unit/dbh", "inch"));
  ASSERT_TRUE(window().fill("import/name", "mine"));
  ASSERT_TRUE(window().click("import/unit/dbh"));
  window().frames(2);
  window().press({ui::Key::escape});  // closes the list only
  window().settle();
  ASSERT_TRUE(is_open());
  window().press({ui::Key::escape});
  window().settle();
  ASSERT_FALSE(is_open());
  ASSERT_FALSE(model().notices.all().empty());
  const ui::Notice notice = model().notices.all().front();
  EXPECT_EQ(notice.title, "Import cancelled");
  ASSERT_TRUE(window().click("toast/choice/" + std::to_string(notice.id) + "/Bring it back"));
  window().settle();
  ASSERT_TRUE(is_open());
  EXPECT_EQ(window().value("import/unit/dbh"), "inch");
  EXPECT_EQ(window().value("import/name"), "mine");
  ASSERT_TRUE(window().click("import/add"));
  window().settle();
  ASSERT_EQ(state().inventories.size(), 1u);
  EXPECT_EQ(state().inventories.front()->name, "mine");
}

TEST_F(ImportTest, QuittingFromInsideTheDialogWorksAndAsksForWhatWasEdited) {
  drop({write_plain("plain.csv")});
  ASSERT_TRUE(choose("import/unit/dbh", "inch"));
  window().press(ui::ActionId::file_quit);
  window().frames(2);
  ASSERT_EQ(model().view.dialog, ui::Dialog::question);
  ASSERT_TRUE(window().click("question/no"));
  window().settle();
  ASSERT_TRUE(is_open());
  EXPECT_EQ(window().value("import/unit/dbh"), "inch");
  EXPECT_FALSE(model().wants_close);
  window().desk().ask_to_close();  // as the window's own button
  window().frames(4);
  ASSERT_TRUE(window().click("question/yes"));
  window().frames(2);
  EXPECT_TRUE(model().wants_close);
}

}  // namespace
}  // namespace stemwise
