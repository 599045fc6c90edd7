#include "io/read_inventory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace stemwise {
namespace {

namespace fs = std::filesystem;

/// All issues in one text, for looking things up.
std::string all(const Issues& issues) {
  std::string text;
  for (const Issue& issue : issues) text += to_string(issue) + "\n";
  return text;
}

class RealFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("STEMWISE_SHARED_DATA");
    data_ = folder != nullptr ? fs::path(folder) : fs::path(STEMWISE_SOURCE_DIR) / ".." / "shared" / "data";
    if (!fs::exists(data_ / "messy")) data_ = fs::path(STEMWISE_SOURCE_DIR) / ".." / ".." / "shared" / "data";
    if (!fs::exists(data_ / "messy")) GTEST_SKIP() << "real data are not here: " << data_;
  }
  Result<Inventory> read(const std::string& name, const ReadOptions& options = {}) const { return read_inventory((data_ / name).string(), options); }
  fs::path data_;
};

double extent_m(const Inventory& inventory) {
  double low = 1e300, high = -1e300;
  for (const Stem& s : inventory.stems) low = std::min(low, s.x_m), high = std::max(high, s.x_m);
  return high - low;
}

TEST_F(RealFilesTest, MessyFilesAreReadAsAPersonWouldReadThem) {
  struct Expected {
    const char* file;
    std::size_t stems;
    double first_dbh_m;
    double extent_m, tolerance_m;
  };
  // Dead stems count: they are kept with their status.
  const std::vector<Expected> files = {{"fia_azimuth_dist_feet_inches.csv", 91, 6.8 * 0.0254, 14.0, 1.0},
                                       {"fortls_tree.list.multi.tls.csv", 13, 0.4599, 20.0, 15.0},
                                       {"ilomantsi_finnish_headers_dm.csv", 357, 0.304, 50.0, 20.0},
                                       {"paleon_GooseEggAllPlots_preamble_polar.csv", 296, 0.43, 60.0, 15.0},
                                       {"paleon_HMC_CR_line_endings_polar.csv", 165, 0.266, 40.0, 10.0},
                                       {"paleon_HMC_census_wide_years_polar.csv", 212, 0.598, 40.0, 10.0},
                                       {"paleon_sylvania_BOM_polar.csv", 73, 0.155, 45.0, 15.0},
                                       {"paracou_circumference_utm_latlon.csv", 300, 1.67 / 3.14159265358979, 130.0, 130.0},
                                       {"scbi2023_stem_table_BOM_cm_and_mm_mixed_head1000.csv", 296, 0.0, 20.0, 15.0},
                                       {"treecompr_inventory.csv", 48, 0.3527, 30.0, 15.0},
                                       {"treecompr_smallinv2.csv", 10, 0.3527, 20.0, 15.0},
                                       {"ecosense_trees_latlon.gpkg", 1518, 0.19, 200.0, 200.0},
                                       {"geosense_mooswald_german_multisheet.xlsx", 34, 0.34, 25.0, 15.0},
                                       {"simanfor_IFN_es_lonlat.xlsx", 72, 0.438, 500000.0, 500000.0}};
  for (const Expected& e : files) {
    const auto r = read(std::string("messy/") + e.file);
    ASSERT_TRUE(r) << e.file << "\n" << all(r.issues);
    EXPECT_EQ(r->stems.size(), e.stems) << e.file;
    EXPECT_NEAR(r->stems.front().dbh_m.value_or(0.0), e.first_dbh_m, 1e-4) << e.file;
    EXPECT_NEAR(extent_m(*r), e.extent_m, e.tolerance_m) << e.file;
  }
}

TEST_F(RealFilesTest, Prf025FieldAndLidarAreRecognisedWithTheirUnits) {
  const auto field = read("prf025/PRF025_Field_original.csv");
  const auto lidar = read("prf025/PRF025_Lidar_original.csv");
  ASSERT_TRUE(field && lidar);
  EXPECT_NEAR(*field->stems[0].dbh_m, 0.149, 1e-9);
  EXPECT_NEAR(*lidar->stems[0].dbh_m, 0.0401739196739485, 1e-12);
  EXPECT_NEAR(field->stems[0].x_m, 312030.0202, 1e-3);
  EXPECT_GT(extent_m(*field), 15.0);
}

TEST_F(RealFilesTest, ForestGeoCensusesHaveMillimetresAndExactDates) {
  const auto r = read("scbi/scbi_2008.csv");
  ASSERT_TRUE(r);
  EXPECT_EQ(r->stems.size(), 40181U);
  EXPECT_NEAR(*r->stems[0].dbh_m, 0.0279, 1e-9);
  EXPECT_EQ(year_of(*r->date), 2008);
  EXPECT_TRUE(r->stems[0].date);
  EXPECT_TRUE(r.issues.empty()) << all(r.issues).substr(0, 500);
}

TEST_F(RealFilesTest, EveryMountRainierCensusReadsWithoutAWord) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(data_ / "mtrainier")) {
    if (entry.path().filename() == "stand_centers.csv") continue;
    const auto r = read_inventory(entry.path().string());
    ASSERT_TRUE(r) << entry.path();
    EXPECT_TRUE(r.issues.empty()) << all(r.issues);
    ++files;
  }
  EXPECT_GE(files, 60U);
}

}  // namespace
}  // namespace stemwise
