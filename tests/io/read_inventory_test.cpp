#include "io/read_inventory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "io/project_file.hpp"
#include "tests/io/sample_project.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ReadInventoryTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("stemwise-" + std::to_string(::getpid()) + "-" + info->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Result<Inventory> read(const std::string& text, const ReadOptions& options = {}, const std::string& name = "plot.csv") const {
    std::ofstream((folder_ / name).string(), std::ios::binary) << text;
    return read_inventory((folder_ / name).string(), options);
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  fs::path folder_;
};

/// All issues in one text, for looking things up.
std::string all(const Issues& issues) {
  std::string text;
  for (const Issue& issue : issues) text += to_string(issue) + "\n";
  return text;
}

std::string notes(const Inventory& inventory) {
  std::string text;
  for (const std::string& note : inventory.source.notes) text += note + "\n";
  return text;
}

TEST_F(ReadInventoryTest, APlainTableIsReadWithItsNamesAndUnits) {
  const auto r = read("id,x_m,y_m,z_m,dbh_cm,species\nA1,1.5,2.25,100.125,30.5,Fagus\nA2,3,4,,,\n");
  ASSERT_TRUE(r) << all(r.issues);
  EXPECT_EQ(r->name, "plot");
  ASSERT_EQ(r->stems.size(), 2U);
  EXPECT_EQ(r->stems[0].source_id, "A1");
  EXPECT_EQ(r->stems[0].source_row, 2);
  EXPECT_EQ(r->stems[0].x_m, 1.5);
  EXPECT_EQ(r->stems[0].z_m, 100.125);
  EXPECT_NEAR(*r->stems[0].dbh_m, 0.305, 1e-12);
  EXPECT_EQ(r->stems[0].species, "Fagus");
  EXPECT_FALSE(r->stems[1].dbh_m);
  EXPECT_FALSE(r->stems[1].z_m);
  EXPECT_TRUE(r.issues.empty()) << all(r.issues);
}

TEST_F(ReadInventoryTest, EveryDelimiterLineEndEncodingAndDecimalSignGivesTheSameStems) {
  const std::vector<std::string> texts = {
      "Baum,x,y,BHD (cm),Baumart\n1,10.5,20.25,31.5,Käfer\n2,11.75,21.5,40,Buche\n",
      "\xEF\xBB\xBF" "Baum,x,y,BHD (cm),Baumart\r\n1,10.5,20.25,31.5,Käfer\r\n2,11.75,21.5,40,Buche\r\n",
      "Baum;x;y;BHD (cm);Baumart\r1;10,5;20,25;31,5;K\xE4" "fer\r2;11,75;21,5;40;Buche",
      "Baum\tx\ty\tBHD (cm)\tBaumart\n1\t10,5\t20,25\t31,5\tKäfer\n\n2\t11,75\t21,5\t40\tBuche\n",
      "Baum|x|y|BHD (cm)|Baumart\n1|10.5|20.25|31.5|Käfer\n2|11.75|21.5|40|Buche\n",
      "\"Baum\",\"x\",\"y\",\"BHD (cm)\",\"Baumart\"\n\"1\",\"10,5\",\"20,25\",\"31,5\",\"Käfer\"\n\"2\",\"11,75\",\"21,5\",\"40\",\"Buche\"\n",
      "Plot 7;;;;\nmeasured by A;;;;\n\nBaum;x;y;BHD (cm);Baumart\n1;10,5;20,25;31,5;Käfer\n2;11,75;21,5;40;Buche\n"};
  for (const std::string& text : texts) {
    const auto r = read(text);
    ASSERT_TRUE(r) << text << all(r.issues);
    ASSERT_EQ(r->stems.size(), 2U) << text;
    EXPECT_EQ(r->stems[0].x_m, 10.5) << text;
    EXPECT_EQ(r->stems[0].y_m, 20.25) << text;
    EXPECT_NEAR(r->stems[0].dbh_m.value_or(0.0), 0.315, 1e-12) << text;
    EXPECT_EQ(r->stems[0].species, "Käfer") << text;
    EXPECT_EQ(r->stems[1].x_m, 11.75) << text;
  }
}

TEST_F(ReadInventoryTest, BadRowsAreNamedAndTheGoodOnesKept) {
  const auto r = read("id,x,y,dbh_cm\n1,1,2,30\n2,abc,2,30\n3,NaN,2,30\n4,1\n5,1,2,thick\n6,4,5,31\n7,,5,31\n8,1,2,3,4,5\n9,inf,1,20\n");
  ASSERT_TRUE(r);
  ASSERT_EQ(r->stems.size(), 2U);
  EXPECT_EQ(r->stems[1].source_id, "6");
  std::set<std::int64_t> rows;
  for (const Issue& issue : r.issues) {
    EXPECT_EQ(issue.severity, Severity::warning);
    EXPECT_EQ(issue.file, path("plot.csv"));
    rows.insert(issue.row);
  }
  EXPECT_EQ(rows, (std::set<std::int64_t>{3, 4, 5, 6, 8, 9, 10}));
  EXPECT_THAT(all(r.issues), HasSubstr("row 3, column x: \"abc\", expected a number"));
  EXPECT_THAT(all(r.issues), HasSubstr("row 6, column dbh_cm: \"thick\""));
  EXPECT_THAT(notes(*r), HasSubstr("bad rows left out: 7"));
}

TEST_F(ReadInventoryTest, AnIdUsedForTwoTreesIsSaidAndForTwoStemsOfOneTreeIsNot) {
  const auto twins = read("id,x_m,y_m,dbh_cm\n1,0,0,30\n2,5,0,31\n1,9,9,32\n2,5.3,0,18\n1,20,9,33\n", {}, "twins.csv");
  ASSERT_TRUE(twins);
  EXPECT_EQ(twins->stems.size(), 5u);
  ASSERT_EQ(twins.issues.size(), 1u) << to_string(twins.issues.back());
  EXPECT_EQ(twins.issues[0].row, 4);
  EXPECT_EQ(twins.issues[0].column, "id");
  EXPECT_NE(twins.issues[0].text.find("row 2"), std::string::npos) << twins.issues[0].text;
  EXPECT_NE(twins.issues[0].text.find("1 more"), std::string::npos) << twins.issues[0].text;
  const auto plots = read("plot,id,x_m,y_m,dbh_cm\nA,1,0,0,30\nA,2,5,0,31\nB,1,50,9,32\nB,2,55,9,33\n", {}, "plots.csv");
  ASSERT_TRUE(plots);
  EXPECT_TRUE(plots.issues.empty()) << to_string(plots.issues.front());
}

TEST_F(ReadInventoryTest, ANanDiameterIsAStemWithoutDiameterAndSaid) {
  const auto r = read("id,x,y,dbh_cm\n1,1,2,nan\n2,3,4,NA\n3,5,6,31\n");
  ASSERT_TRUE(r);
  EXPECT_EQ(r->stems.size(), 3U);
  EXPECT_THAT(all(r.issues), HasSubstr("row 2, column dbh_cm"));
  EXPECT_EQ(r.issues.size(), 1U);
}

TEST_F(ReadInventoryTest, NothingUsableIsAFailureThatSaysWhatHelps) {
  const std::vector<std::pair<std::string, std::string>> cases = {{"", "empty"},
                                                                  {"\n \n", "empty"},
                                                                  {"x,y,dbh\n", "no rows"},
                                                                  {"x#y#dbh\n1#2#3\n", "no header"},
                                                                  {"species,dbh\nFagus,30\nPicea,20\n", "positions"},
                                                                  {"1,2,3\n4,5,6\n", "no header"},
                                                                  {"x,y,dbh\na,b,c\nd,e,f\n", "no row is usable"},
                                                                  {std::string("\0\1\2\3\4", 5), "neither text"}};
  for (const auto& [text, expected] : cases) {
    const auto r = read(text);
    ASSERT_FALSE(r) << text;
    EXPECT_TRUE(has_error(r.issues));
    EXPECT_THAT(all(r.issues), HasSubstr(expected)) << text;
    EXPECT_FALSE(r.issues.front().help.empty()) << text;
  }
  EXPECT_FALSE(read_inventory(path("missing.csv")));
  EXPECT_FALSE(read_inventory(folder_.string()));
}

TEST_F(ReadInventoryTest, UnitsComeFromTheHeaderElseTheValuesAndAGuessIsAWarning) {
  const auto dbh = [&](const std::string& name, const std::string& a, const std::string& b) {
    const auto r = read("x,y," + name + "\n1,2," + a + "\n3,9," + b + "\n8,7," + b + "\n");
    return r && r->stems.front().dbh_m ? std::pair(*r->stems.front().dbh_m, r.issues.size()) : std::pair(0.0, std::size_t{99});
  };
  EXPECT_NEAR(dbh("dbh_mm", "305", "200").first, 0.305, 1e-12);
  EXPECT_EQ(dbh("dbh_mm", "305", "200").second, 0U);
  EXPECT_NEAR(dbh("DBH [m]", "0.305", "0.2").first, 0.305, 1e-12);
  EXPECT_NEAR(dbh("dbh (in)", "12", "9").first, 0.3048, 1e-12);
  EXPECT_NEAR(dbh("CBH cm", "94.2477796", "80").first, 0.30, 1e-9);
  EXPECT_NEAR(dbh("d130", "30.5", "20").first, 0.305, 1e-12);
  EXPECT_EQ(dbh("d130", "30.5", "20").second, 1U);
  EXPECT_NEAR(dbh("DHP", "0.305", "0.2").first, 0.305, 1e-12);
  EXPECT_NEAR(dbh("Diameter", "305", "420").first, 0.305, 1e-12);
}

TEST_F(ReadInventoryTest, OptionsOverrideWhatIsRecognised) {
  ReadOptions options;
  options.columns = {{"x", "Rechts"}, {"y", "Hoch"}, {"dbh", "Wert"}};
  options.units = {{"dbh", "mm"}, {"x", "ft"}};
  options.date = date_from_civil(2021, 5, 4);
  const auto r = read("Rechts,Hoch,Wert,x,y\n10,20,305,1,1\n11,21,200,1,1\n", options);
  ASSERT_TRUE(r) << all(r.issues);
  EXPECT_NEAR(r->stems[0].x_m, 3.048, 1e-12);
  EXPECT_NEAR(*r->stems[0].dbh_m, 0.305, 1e-12);
  EXPECT_EQ(r->date, date_from_civil(2021, 5, 4));
  options.columns["x"] = "Nothing";
  const auto bad = read("Rechts,Hoch,Wert\n10,20,305\n", options);
  ASSERT_FALSE(bad);
  EXPECT_THAT(all(bad.issues), HasSubstr("no column Nothing"));
}

TEST_F(ReadInventoryTest, AzimuthAndDistanceAreTurnedClockwiseFromNorth) {
  const auto r = read("tree,azimuth,distance_m,dbh_cm\n1,90,10,30\n2,180,5,20\n3,-1,5,20\n4,20°,\"2,8m\",20\n");
  ASSERT_TRUE(r) << all(r.issues);
  ASSERT_EQ(r->stems.size(), 3U);
  EXPECT_NEAR(r->stems[0].x_m, 10.0, 1e-9);
  EXPECT_NEAR(r->stems[0].y_m, 0.0, 1e-9);
  EXPECT_NEAR(r->stems[1].y_m, -5.0, 1e-9);
  EXPECT_NEAR(r->stems[2].y_m, 2.8 * std::cos(20.0 * 3.14159265358979 / 180.0), 1e-9);
  EXPECT_THAT(all(r.issues), HasSubstr("row 4, column azimuth"));
}

TEST_F(ReadInventoryTest, LongitudeAndLatitudeBecomeUtm) {
  const auto r = read("lon,lat,dbh_cm\n7.8775,48.2693,30\n7.8776,48.2693,31\n");
  ASSERT_TRUE(r) << all(r.issues);
  EXPECT_EQ(r->source.epsg, 32632);
  EXPECT_NEAR(r->stems[1].x_m - r->stems[0].x_m, 7.42, 0.05);
}

TEST_F(ReadInventoryTest, PlotsOfOneFileAreToldApartOnDemandAndWarnedAboutElse) {
  const std::string text = "plot,x,y,dbh_cm\nA,1,2,30\nA,3,4,31\nA,9,8,20\nB,1,3,30\nB,4,4,30\nB,8,9,22\n";
  const auto both = read(text);
  ASSERT_TRUE(both);
  EXPECT_THAT(all(both.issues), HasSubstr("--plot"));
  ReadOptions options;
  options.plot = "B";
  const auto one = read(text, options);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->stems.size(), 3U);
  options.plot = "C";
  const auto none = read(text, options);
  ASSERT_FALSE(none);
  EXPECT_THAT(all(none.issues), HasSubstr("A, B"));
}

TEST_F(ReadInventoryTest, DeadStemsAreKeptWithTheirStatusAndCounted) {
  const std::string text = "x,y,dbh_cm,status\n1,2,30,A\n3,4,20,dead\n5,6,22,D\n7,8,,G\n9,1,25,?\n";
  const auto inventory = read(text);
  ASSERT_TRUE(inventory);
  ASSERT_EQ(inventory->stems.size(), 5U);
  EXPECT_EQ(inventory->stems[0].status, StemStatus::alive);
  EXPECT_EQ(inventory->stems[1].status, StemStatus::dead);
  EXPECT_EQ(inventory->stems[3].status, StemStatus::dead);
  EXPECT_FALSE(inventory->stems[3].dbh_m);
  EXPECT_THAT(notes(*inventory), HasSubstr("dead by their status: 3"));
}

TEST_F(ReadInventoryTest, WhatTheCrewDidNotFindIsNoSightingAndWhatTheyFelledIsRemoved) {
  const auto inventory = read("id,x,y,dbh_cm,status\n1,1,2,30,alive\n2,3,4,20,missing\n3,5,6,22,cut\n4,7,8,,stump\n5,9,1,25,dead\n");
  ASSERT_TRUE(inventory) << all(inventory.issues);
  ASSERT_EQ(inventory->stems.size(), 4U);
  EXPECT_EQ(inventory->stems[1].status, StemStatus::removed);
  EXPECT_EQ(inventory->stems[2].status, StemStatus::removed);
  EXPECT_EQ(inventory->stems[3].status, StemStatus::dead);
  EXPECT_THAT(notes(*inventory), HasSubstr("not found by their status, so not seen and left out: 1"));
  EXPECT_THAT(notes(*inventory), HasSubstr("removed by their status: 2"));
  EXPECT_TRUE(inventory.issues.empty()) << all(inventory.issues);
}

TEST_F(ReadInventoryTest, UnknownStatusWordsAreNamedWithTheirRowsUntilSomeoneTellsThem) {
  const std::string text = "id,x,y,dbh_cm,status\n1,1,2,30,A\n2,3,4,20,kaputt\n3,5,6,22,kaputt\n4,7,8,20,?\n5,7,9,20,QX\n";
  const auto inventory = read(text);
  ASSERT_TRUE(inventory);
  ASSERT_EQ(inventory.issues.size(), 1U) << all(inventory.issues);
  EXPECT_THAT(all(inventory.issues), HasSubstr("\"kaputt\" (2 rows), \"QX\" (1 row)"));
  EXPECT_THAT(all(inventory.issues), HasSubstr("--status"));
  ReadOptions options;
  options.status_codes = {{"kaputt", StemStatus::dead}, {"QX", StemStatus::missing}};
  const auto told = read(text, options);
  ASSERT_TRUE(told);
  EXPECT_TRUE(told.issues.empty()) << all(told.issues);
  EXPECT_EQ(told->stems.size(), 4U);
  EXPECT_EQ(told->stems[1].status, StemStatus::dead);
}

TEST_F(ReadInventoryTest, RowsThatStandTwiceAreReadOnceAndTold) {
  const std::string rows = "1,1.5,2.5,30.1\n2,3.5,4.5,20.2\n3,5.5,6.5,22.3\n";
  const auto twice = read("id,x,y,dbh_cm\n" + rows + rows);
  ASSERT_TRUE(twice);
  EXPECT_EQ(twice->stems.size(), 3U);
  EXPECT_THAT(all(twice.issues), HasSubstr("row 5: says the very same as row 2 (and 2 more rows repeat an earlier one); they are left out"));
  const auto unnamed = read("x,y,dbh_cm\n1.5,2.5,30.1\n1.5,2.5,30.1\n3.5,4.5,20.2\n");
  ASSERT_TRUE(unnamed);
  EXPECT_EQ(unnamed->stems.size(), 3U);
  EXPECT_THAT(all(unnamed.issues), HasSubstr("kept, for the rows have no ids"));
}

TEST_F(ReadInventoryTest, SeveralStemsOfOneTreeAreNoRepetition) {
  const auto stems = read("tree,stem,x,y,dbh_cm\n1,1,1.5,2.5,30.1\n1,2,1.5,2.5,30.1\n2,1,3.5,4.5,20.2\n");
  ASSERT_TRUE(stems);
  EXPECT_EQ(stems->stems.size(), 3U);
  EXPECT_TRUE(stems.issues.empty()) << all(stems.issues);
}

TEST_F(ReadInventoryTest, TheWholeColumnTellsTheOrderOfDayAndMonth) {
  const auto day_first = read("x,y,date_mesure\n1,2,1/05/2021\n3,4,2/05/2021\n5,6,28/05/2021\n");
  EXPECT_EQ(day_first->stems[1].date, date_from_civil(2021, 5, 2));
  EXPECT_THAT(notes(*day_first), HasSubstr("day before month (told by 28/05/2021)"));
  const auto month_first = read("x,y,Fecha\n1,2,5/1/2021\n3,4,5/2/2021\n5,6,5/28/2021\n");
  EXPECT_EQ(month_first->stems[1].date, date_from_civil(2021, 5, 2));
  EXPECT_EQ(read("x,y,Data\n1,2,44329\n3,4,44330\n5,6,44331\n")->date, date_from_civil(2021, 5, 14));
  EXPECT_EQ(read("x,y,Datum\n1,2,13. Mai 2021\n3,4,13. Mai 2021\n")->date, date_from_civil(2021, 5, 13));
}

TEST_F(ReadInventoryTest, DatesThatCannotBeReadAreToldWithAnExampleAndTheOption) {
  for (const auto& [cell, why] : {std::pair("5/6/2021", "day or with the month"), std::pair("soon", "no date that can be read")}) {
    const auto r = read(std::string("x,y,date\n1,2,") + cell + "\n3,4," + cell + "\n");
    ASSERT_TRUE(r);
    EXPECT_FALSE(r->date);
    EXPECT_THAT(all(r.issues), HasSubstr(std::string("column date: \"") + cell));
    EXPECT_THAT(all(r.issues), HasSubstr(why));
    EXPECT_THAT(all(r.issues), HasSubstr("--date"));
  }
  ReadOptions options;
  options.date = date_from_civil(2021, 6, 5);
  EXPECT_EQ(read("x,y,date\n1,2,soon\n3,4,soon\n", options).issues.size(), 1U);  // no diameter; the date was told
}

TEST_F(ReadInventoryTest, IdsAndGirthsAreFoundInSpanishPortugueseAndFrench) {
  const auto r = read("Árbol,x,y,perimeter (cm)\nA1,1,2,100\nA2,3,4,110\n");
  ASSERT_TRUE(r) << all(r.issues);
  EXPECT_EQ(r->stems[0].source_id, "A1");
  EXPECT_NEAR(*r->stems[0].dbh_m, 1.0 / 3.14159265358979, 1e-9);
  EXPECT_EQ(read("Arvore,x,y\nB1,1,2\nB2,3,4\n")->stems[1].source_id, "B2");
}

TEST_F(ReadInventoryTest, MixedUnitsAndRepeatedHeadersAreTold) {
  std::string text = "id,x,y,dbh\n";
  for (int i = 0; i < 20; ++i) text += std::to_string(i) + "," + std::to_string(2 * i) + ".5," + std::to_string(i * i % 17) + ".5," + (i % 2 == 0 ? std::to_string(200 + 9 * i) : std::to_string(20 + i) + ".4") + "\n";
  EXPECT_THAT(all(read(text).issues), HasSubstr("two units seem to be mixed"));
  EXPECT_THAT(all(read("id,x,x,y,dbh_cm\n1,1,9,2,30\n2,3,9,4,31\n").issues), HasSubstr("the header has this name 2 times; column 2 was read"));
}

TEST_F(ReadInventoryTest, TheDateIsTheMedianOfTheRowsElseFromTheName) {
  EXPECT_EQ(read("x,y,date\n1,2,2013-03-29\n3,4,2013-04-01\n5,6,2013-04-20\n")->date, date_from_civil(2013, 4, 1));
  EXPECT_EQ(read("x,y\n1,2\n3,4\n", {}, "north_2023-05-04.csv")->date, date_from_civil(2023, 5, 4));
  EXPECT_EQ(read("x,y\n1,2\n3,4\n", {}, "north_2018.csv")->date, date_from_civil(2018, 7, 1));
  EXPECT_FALSE(read("x,y,date\n1,2,17826\n3,4,17825\n")->date);
}

TEST_F(ReadInventoryTest, UtmSizedNumbersLoseNothing) {
  const auto r = read("x,y\n412801.43250000001,5280085.5350000001\n312030.02020000003,5096043.1850000005\n");
  ASSERT_TRUE(r);
  EXPECT_EQ(r->stems[0].x_m, 412801.43250000001);
  EXPECT_EQ(r->stems[1].y_m, 5096043.1850000005);
}

TEST_F(ReadInventoryTest, AConstantPlotCentreIsNotAPosition) {
  const auto r = read("Easting,Northing,Azim,Dist,DBH_cm\n312029.5,5096039.4,10,5,30\n312029.5,5096039.4,100,6,31\n312029.5,5096039.4,200,7,31\n");
  ASSERT_TRUE(r);
  EXPECT_NEAR(r->stems[0].y_m, 5.0 * std::cos(10.0 * 3.14159265358979 / 180.0), 1e-9);
}

TEST_F(ReadInventoryTest, AnInventoryOfAProjectIsRead) {
  ASSERT_TRUE(write_project(sample_project(), path("p.gpkg")));
  ReadOptions options;
  options.sheet = "2023";
  const auto r = read_inventory(path("p.gpkg"), options);
  ASSERT_TRUE(r) << all(r.issues);
  EXPECT_EQ(r->name, "2023");
  EXPECT_EQ(r->stems.size(), 12U);
  const auto which = read_inventory(path("p.gpkg"));
  ASSERT_FALSE(which);
  EXPECT_THAT(all(which.issues), HasSubstr("2019, 2023, no date"));
}

}  // namespace
}  // namespace stemwise
