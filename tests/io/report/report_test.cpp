#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <set>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/random.hpp"
#include "core/project/commands.hpp"
#include "core/project/project.hpp"
#include "core/survey/coverage.hpp"
#include "core/survey/field_check.hpp"
#include "core/survey/report_model.hpp"
#include "io/report/field_check.hpp"
#include "io/report/recorded_pages.hpp"
#include "io/report/write_report.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

Inventory survey(const std::string& name, int year, int stems, double growth_m, std::uint64_t seed) {
  Inventory inventory;
  inventory.name = name;
  inventory.date = date_from_civil(year, 7, 1);
  Random places(1), noise(seed);
  for (int i = 0; i < stems; ++i) {
    Stem stem;
    stem.source_id = std::to_string(i + 1);
    stem.x_m = places.uniform(0.0, 100.0);
    stem.y_m = places.uniform(0.0, 80.0);
    const double dbh_m = 0.08 + 0.35 * places.uniform() * places.uniform();
    stem.dbh_m = dbh_m + growth_m * (0.5 + places.uniform()) + noise.normal(0.0, 0.008);
    stem.species = i % 3 == 0 ? "Picea abies" : "Fagus sylvatica";
    inventory.stems.push_back(stem);
  }
  return inventory;
}

SurveyAlignment alignment_of(const ProjectState& state, std::size_t common) {
  SurveyAlignment result;
  result.reference = state.reference;
  for (const auto& inventory : state.inventories) {
    InventoryAlignment a;
    a.inventory = inventory->id;
    a.status = inventory->id == state.reference ? AlignmentStatus::reference : AlignmentStatus::aligned;
    a.observed.seen = {true, true, true, false, false, false};
    a.overlap = 0.83;
    a.matched = static_cast<int>(common);
    a.residual_rms_m = 0.071;
    a.position_noise_m = 0.1;
    a.acceptance = {2214.3, 31.2, 2180.1, 34.2, 20.0, 0.9999};
    result.inventories.push_back(a);
  }
  for (std::size_t k = 1; k < state.inventories.size(); ++k) {
    for (std::size_t i = 0; i < common; ++i) {
      const auto index = static_cast<std::int64_t>(i);
      result.matches.push_back({{state.inventories[k - 1]->id, index}, {state.inventories[k]->id, index}, 0.05, 0.95, MatchState::automatic, {}, {}});
    }
  }
  return result;
}

/// Three surveys; the middle one has 20 stems that the first has not, the last lost 15 of them.
ProjectState three_surveys() {
  Project project;
  project.execute(set_title("Stand 14 & <sons>"));
  project.execute(add_inventory(survey("2015", 2015, 380, 0.0, 2)));
  project.execute(add_inventory(survey("2019", 2019, 400, 0.014, 3)));
  project.execute(add_inventory(survey("2023", 2023, 385, 0.029, 4)));
  std::vector<std::pair<InventoryId, Coverage>> coverages;
  for (const auto& inventory : project.state().inventories) coverages.emplace_back(inventory->id, estimate_coverage(*inventory));
  project.execute(apply_alignment(alignment_of(project.state(), 380), coverages));
  return project.state();
}

ReportModel model_of(const ProjectState& state, const ReportOptions& options = {}) {
  return make_report_model(state, derive_tables(state), options);
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

/// Kept when STEMWISE_TEST_OUTPUT names a folder, for people who want to look.
fs::path output_folder() {
  const char* kept = std::getenv("STEMWISE_TEST_OUTPUT");
  const fs::path folder = kept != nullptr ? fs::path(kept) : fs::temp_directory_path() / ("stemwise_report_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  return folder;
}

TEST(Report, WhoWasDeadOrIsFoundDeadIsNoMissingStem) {
  ProjectState state = three_surveys();
  const int before = model_of(state).growth[1].missing_stems;
  const InventoryId second = state.by_date()[1], third = state.by_date()[2];
  Inventory earlier = *state.find(second), later = *state.find(third);
  std::set<TreeId> seen_later;
  for (std::size_t i = 0; i < later.stems.size(); ++i) seen_later.insert(state.tree_of({third, static_cast<std::int64_t>(i)}));
  int dead = 0;
  for (std::size_t i = 0; i < earlier.stems.size(); ++i)
    if (!seen_later.contains(state.tree_of({second, static_cast<std::int64_t>(i)}))) earlier.stems[i].status = StemStatus::dead, ++dead;
  ASSERT_GE(dead, before);
  later.stems.front().status = StemStatus::dead;
  for (auto& inventory : state.inventories) {
    if (inventory->id == second) inventory = std::make_shared<const Inventory>(earlier);
    if (inventory->id == third) inventory = std::make_shared<const Inventory>(later);
  }
  EXPECT_EQ(model_of(state).growth[1].missing_stems, 0);
}

TEST(Report, CountsNewAndMissingStemsOfEveryStep) {
  const ReportModel model = model_of(three_surveys());
  ASSERT_EQ(model.growth.size(), 2u);
  EXPECT_EQ(model.growth[0].survivors, 380);
  EXPECT_GE(model.growth[0].new_stems, 17);  // those at the very edge count as outside the first survey's coverage
  EXPECT_LE(model.growth[0].new_stems, 20);
  EXPECT_GE(model.growth[1].missing_stems, 16);  // 20 are gone: two lie outside the last outline, two at its edge (next test)
  EXPECT_LE(model.growth[1].missing_stems, 20);
  EXPECT_NEAR(model.growth[1].row.median_change_m, 0.015, 0.002);
}

/// The gone trees that are not listed as missing, and how far the edge of the last survey's coverage is from each.
TEST(Report, AGoneTreeIsUnresolvedOnlyAtTheVeryEdgeOfTheLastCoverage) {
  const ProjectState state = three_surveys();
  const Tables tables = derive_tables(state);
  const InventoryId middle = state.inventories[1]->id, last = state.inventories[2]->id;
  const auto coverage = std::find_if(tables.coverages.begin(), tables.coverages.end(), [&](const CoverageRow& row) { return row.inventory == last; });
  ASSERT_NE(coverage, tables.coverages.end());
  // An outline made of stems is off by up to three quarters of their spacing, 0.55 of the side of a stem's share of the ground.
  const double doubt_m = 0.75 * 0.55 * std::sqrt(coverage->area_sq_m / static_cast<double>(state.inventories[2]->stems.size()));
  ASSERT_LT(doubt_m, 3.0);
  int gone = 0, missing = 0;
  for (const ObservationRow& row : tables.observations) {
    if (row.stem.inventory != middle || row.stem.index < 380) continue;
    ++gone;
    missing += row.fate == Fate::missing ? 1 : 0;
    if (row.fate == Fate::missing) continue;
    const bool is_inside = contains(coverage->in_reference, row.position_m.head<2>());
    const double edge_m = distance_to_edge_m(coverage->in_reference, row.position_m.head<2>());
    EXPECT_TRUE(!is_inside || edge_m < doubt_m) << "stem " << row.stem.index << " " << to_string(row.fate) << ", inside, " << edge_m << " m from the edge";
  }
  EXPECT_EQ(gone, 20);
  EXPECT_GE(missing, 16);
}

TEST(Report, DbhClassesCountEveryLivingStemOnceWithTheLowerLimitIncluded) {
  Project project;
  Inventory inventory = survey("2015", 2015, 6, 0.0, 2);
  const double dbh_m[] = {0.10, 0.149999, 0.15, 0.30, 0.0999, 0.2};
  for (std::size_t i = 0; i < 6; ++i) inventory.stems[i].dbh_m = dbh_m[i];
  inventory.stems[5].dbh_m.reset();
  project.execute(add_inventory(inventory));
  const ProjectState state = project.state();
  const ReportModel model = model_of(state);
  if (model.placed == 0) GTEST_SKIP() << "a lone inventory has no place before it was aligned";
  ASSERT_FALSE(model.dbh_classes.empty());
  EXPECT_DOUBLE_EQ(model.dbh_classes.front().low_cm, 5.0);
  EXPECT_EQ(model.dbh_classes[0].stems[0], 1);
  EXPECT_EQ(model.dbh_classes[1].stems[0], 2);
  EXPECT_EQ(model.dbh_classes[2].stems[0], 1);
  EXPECT_DOUBLE_EQ(model.dbh_classes.back().low_cm, 30.0);
  EXPECT_EQ(model.without_dbh[0], 1);
}

TEST(Report, PerHectareFiguresNameTheirArea) {
  const ProjectState state = three_surveys();
  const ReportModel own = model_of(state);
  ASSERT_TRUE(own.surveys[0].area);
  EXPECT_EQ(own.surveys[0].area->source, "outline of the stems");
  ReportOptions options;
  options.area_ha = 0.8;
  const ReportModel given = model_of(state, options);
  EXPECT_EQ(given.surveys[0].area->source, "given");
  EXPECT_DOUBLE_EQ(given.surveys[0].area->ha, 0.8);
}

TEST(Report, HtmlStandsAloneAndEscapesWhatItQuotes) {
  const std::string html = report_html(make_report_document(model_of(three_surveys()), "Stemwise test"));
  EXPECT_NE(html.find("Stand 14 &amp; &lt;sons&gt;"), std::string::npos);
  EXPECT_NE(html.find("<svg"), std::string::npos);
  for (const char* outside : {"src=\"http", "href=\"http", "@import", "<script"}) EXPECT_EQ(html.find(outside), std::string::npos) << outside;
}

TEST(Report, EveryFormatIsWrittenAndTheSameTwice) {
  const ReportDocument document = make_report_document(model_of(three_surveys()), "Stemwise test");
  const fs::path folder = output_folder();
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  for (const std::string suffix : {".html", ".csv", ".xlsx", ".pdf"}) {
    const fs::path first = folder / ("report" + suffix), second = folder / ("again" + suffix);
    ASSERT_TRUE(write_report(first.string(), document)) << suffix;
    ASSERT_TRUE(write_report(second.string(), document)) << suffix;
    EXPECT_GT(fs::file_size(first), 2000u);
    EXPECT_EQ(text_of(first), text_of(second)) << suffix;
  }
}

TEST(Report, ThePagesToLookAtAreThoseOfThePdf) {
  const ReportDocument document = make_report_document(model_of(three_surveys()), "Stemwise test");
  const std::string pdf = *report_pdf(document);
  int pages = 0;
  for (std::size_t at = pdf.find("/Type /Page "); at != std::string::npos; at = pdf.find("/Type /Page ", at + 1)) ++pages;
  const RecordedPages recorded = report_pages(document);
  ASSERT_GT(pages, 2);
  EXPECT_EQ(recorded.count(), pages);
  const PagePicture cover = recorded.picture(0, 600), last = recorded.picture(pages - 1, 300);
  EXPECT_EQ(cover.height_px, 849);  // A4
  EXPECT_EQ(last.width_px, 300);
  ASSERT_EQ(cover.rgba.size(), 600u * 849u * 4u);
  const auto red = [&](int x, int y) { return cover.rgba[(static_cast<std::size_t>(y) * 600 + static_cast<std::size_t>(x)) * 4]; };
  EXPECT_LT(red(300, 3), 100);  // the bar of the accent's green along the top
  EXPECT_EQ(red(300, 20), 255);
  EXPECT_EQ(cover.rgba[3], 255);
}

TEST(Report, AWorkbookIsReadBackByGdalWithASheetPerTableAndNumbersAsNumbers) {
  GDALAllRegister();
  const std::string path = (output_folder() / "read_back.xlsx").string();
  const ReportDocument document = make_report_document(model_of(three_surveys()), "Stemwise test");
  ASSERT_TRUE(write_report(path, document));
  GDALDataset* book = GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR);
  ASSERT_NE(book, nullptr);
  int tables = 1;  // the first sheet
  for (const ReportSection& section : document.sections)
    for (const ReportBlock& block : section.blocks)
      if (const auto* table = std::get_if<ReportTable>(&block)) tables += table->rows.empty() ? 0 : 1;
  EXPECT_EQ(book->GetLayerCount(), tables);
  OGRLayer* stand = book->GetLayerByName("Stand figures");
  ASSERT_NE(stand, nullptr);
  bool found = false;
  for (const auto& row : *stand) found = found || (std::string(row->GetFieldAsString(0)) == "2015" && row->GetFieldAsInteger(1) == 380);
  EXPECT_TRUE(found);
  GDALClose(book);
}

TEST(Report, TheChosenRulesFlagTheirTreesAndCountWhatOthersWould) {
  ProjectState state = three_surveys();
  for (const auto& [key, value] : settings_of(*find_rule_pack("ctfs"))) state.settings[key] = value;
  const Tables tables = derive_tables(state);
  const ReportModel model = model_of(state);
  EXPECT_EQ(model.rule_pack, "ctfs");
  EXPECT_EQ(model.rules.size(), 11u);
  int broken = 0, flagged_pairs = 0, flagged_trees = 0;
  for (const ReportRule& rule : model.rules) broken += rule.is_chosen ? rule.count.broken : 0;
  for (const MatchRow& match : tables.matches)
    flagged_pairs += std::find(match.flags.begin(), match.flags.end(), "ctfs_shrinkage") != match.flags.end() ? 1 : 0;
  for (const TreeRow& tree : tables.trees) flagged_trees += std::find(tree.flags.begin(), tree.flags.end(), "ctfs_shrinkage") != tree.flags.end() ? 1 : 0;
  EXPECT_EQ(broken, static_cast<int>(model.flagged.size()));
  EXPECT_EQ(broken, flagged_pairs);
  EXPECT_GT(flagged_trees, 0);
  EXPECT_LE(flagged_trees, flagged_pairs);
  for (const auto& [key, value] : settings_of(std::nullopt)) state.settings[key] = value;
  EXPECT_TRUE(model_of(state).flagged.empty());
}

TEST(Report, TheFieldCheckLeadsToEveryDoubtfulTreeFromThreeSureOnes) {
  ProjectState state = three_surveys();
  state.georeference = {GeoreferenceKind::anchor, {48.77, 9.17, 400.0}, {0, 0, 0}, 30.0, 0, 0.0, "anchor"};
  const Tables tables = derive_tables(state);
  const FieldCheck check = make_field_check(state, tables, 20);
  ASSERT_FALSE(check.rows.empty());
  EXPECT_EQ(check.north, "true north");
  for (const FieldCheckRow& row : check.rows) {
    ASSERT_EQ(row.bearings.size(), 3u);
    for (const FieldBearing& b : row.bearings) {
      const double angle = (b.azimuth_deg - 30.0) * 3.14159265358979 / 180.0;
      const Eigen::Vector2d there = tables.find(b.from)->position_m.head<2>() + b.distance_m * Eigen::Vector2d(std::sin(angle), std::cos(angle));
      EXPECT_LT((there - row.position_m.head<2>()).norm(), 1e-6);
      EXPECT_EQ(tables.find(b.from)->fate, Fate::survivor);
    }
    EXPECT_LE(row.bearings[0].distance_m, row.bearings[1].distance_m);
  }
  const std::string path = (output_folder() / "check.gpx").string();
  ASSERT_TRUE(write_field_check_gpx(path, check, state.georeference, "Stemwise test"));
  GDALAllRegister();
  GDALDataset* gpx = GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR);
  ASSERT_NE(gpx, nullptr);
  EXPECT_EQ(gpx->GetLayerByName("waypoints")->GetFeatureCount(), static_cast<GIntBig>(check.rows.size()));
  GDALClose(gpx);
  EXPECT_FALSE(write_field_check_gpx(path, check, Georeference{}, "Stemwise test"));
}

TEST(Report, ARefusedPathLeavesNothingBehind) {
  const ReportDocument document = make_report_document(model_of(three_surveys()), "Stemwise test");
  EXPECT_FALSE(write_report("/nowhere/at/all/report.pdf", document));
  EXPECT_FALSE(write_report("/nowhere/at/all/report.html", document));
  const fs::path folder = output_folder() / "unknown";
  fs::create_directories(folder);
  EXPECT_FALSE(write_report((folder / "report.docx").string(), document));
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace stemwise
