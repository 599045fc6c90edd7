#include "io/underlay/read_raster_underlay.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "io/crs.hpp"
#include "io/gdal_session.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

class RasterFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    register_gdal();
    folder_ = fs::path(::testing::TempDir()) / ("raster-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  struct Picture {
    int width = 40, height = 30;
    std::vector<GDALDataType> bands{GDT_Byte, GDT_Byte, GDT_Byte};
    double pixel = 1.0, left = 0.0, top = 30.0;
    int epsg = 0;
    bool is_placed = true;
    std::optional<double> no_data;
  };
  /// Every band has the value of `value(x, y, band)`.
  template <class Value>
  std::string write(const std::string& name, const Picture& p, const Value& value) const {
    auto* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    GDALDataset* dataset = driver->Create(path(name).c_str(), p.width, p.height, static_cast<int>(p.bands.size()), p.bands.front(), nullptr);
    double transform[6] = {p.left, p.pixel, 0.0, p.top, 0.0, -p.pixel};
    if (p.is_placed) dataset->SetGeoTransform(transform);
    if (p.epsg) dataset->SetProjection(crs_wkt(p.epsg).c_str());
    for (int band = 1; band <= static_cast<int>(p.bands.size()); ++band) {
      std::vector<float> values;
      for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) values.push_back(static_cast<float>(value(x, y, band)));
      if (p.no_data) dataset->GetRasterBand(band)->SetNoDataValue(*p.no_data);
      EXPECT_EQ(dataset->GetRasterBand(band)->RasterIO(GF_Write, 0, 0, p.width, p.height, values.data(), p.width, p.height, GDT_Float32, 0, 0), CE_None);
    }
    GDALClose(dataset);
    return path(name);
  }

  static UnderlayRequest local(const std::string& file) { return {file, {}, {}, Eigen::AlignedBox2d(Eigen::Vector2d(-10.0, -10.0), Eigen::Vector2d(50.0, 50.0))}; }
  static void expect_refusal(const Result<RasterUnderlay>& read, const std::string& words) {
    ASSERT_FALSE(read);
    const Issue& issue = read.issues.front();
    EXPECT_NE(issue.text.find(words), std::string::npos) << issue.text;
    EXPECT_FALSE(issue.help.empty());
    EXPECT_FALSE(issue.file.empty());
  }

  fs::path folder_;
};

TEST_F(RasterFiles, AGeoTiffWithoutASystemLiesInLocalCoordinates) {
  const auto read = read_raster_underlay(local(write("a.tif", {}, [](int x, int, int band) { return band == 1 ? 6 * x : 50 * band; })));
  ASSERT_TRUE(read) << to_string(read.issues.front());
  EXPECT_EQ(read->width_px, 40);
  EXPECT_EQ(read->height_px, 30);
  EXPECT_NEAR((read->node_m(0, 0) - Eigen::Vector2d(0.0, 30.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((read->node_m(1, 1) - Eigen::Vector2d(40.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(read->rgba[4 * 10], 60);
  EXPECT_EQ(read->rgba[4 * 10 + 1], 100);
  EXPECT_EQ(read->rgba[4 * 10 + 2], 150);
  EXPECT_EQ(read->rgba[4 * 10 + 3], 255);
  EXPECT_NEAR(read->pixel_m, 1.0, 1e-9);
  EXPECT_FALSE(read->is_terrain);
}

TEST_F(RasterFiles, APngWithAWorldFileLiesWhereThatSays) {
  const std::string tif = write("a.tif", {.is_placed = false}, [](int, int, int) { return 128; });
  expect_refusal(read_raster_underlay(local(tif)), "does not say where it lies");
  auto* source = static_cast<GDALDataset*>(GDALOpen(tif.c_str(), GA_ReadOnly));
  GDALClose(GetGDALDriverManager()->GetDriverByName("PNG")->CreateCopy(path("a.png").c_str(), source, false, nullptr, nullptr, nullptr));
  GDALClose(source);
  const auto without = read_raster_underlay(local(path("a.png")));
  expect_refusal(without, "does not say where it lies");
  EXPECT_NE(without.issues[0].help.find("a.pgw"), std::string::npos) << without.issues[0].help;
  std::ofstream(path("a.pgw")) << "0.5\n0\n0\n-0.5\n5.25\n19.75\n";
  const auto read = read_raster_underlay(local(path("a.png")));
  ASSERT_TRUE(read) << to_string(read.issues.front());
  EXPECT_NEAR((read->node_m(0, 0) - Eigen::Vector2d(5.0, 20.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(read->pixel_m, 0.5, 1e-9);
}

TEST_F(RasterFiles, OnlyWhatLiesAroundTheStemsIsReadAndNeverMoreThanTheLimit) {
  const std::string file = write("a.tif", {.width = 6000, .height = 300, .bands = {GDT_Byte}, .pixel = 0.01, .left = 0.0, .top = 3.0}, [](int x, int, int) { return x / 30; });
  const auto whole = read_raster_underlay(local(file));
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->width_px, most_raster_px);
  UnderlayRequest request = local(file);
  request.area_in_reference_m = {Eigen::Vector2d(20.0, 0.0), Eigen::Vector2d(25.0, 3.0)};
  const auto part = read_raster_underlay(request);
  ASSERT_TRUE(part);
  EXPECT_NEAR(part->width_px, 500, 2);
  EXPECT_NEAR(part->node_m(0, 0).x(), 20.0, 0.02);
  EXPECT_NEAR(part->rgba[0], 2000 / 30, 1);
  request.area_in_reference_m = {Eigen::Vector2d(200.0, 0.0), Eigen::Vector2d(250.0, 3.0)};
  expect_refusal(read_raster_underlay(request), "lies away from the stems");
}

TEST_F(RasterFiles, HeightsBecomeShadedReliefAndGapsStayOpen) {
  const auto height = [](int x, int y, int) { return x == 3 && y == 3 ? -9999.0 : 5.0 * std::sin(x / 4.0); };
  const auto read = read_raster_underlay(local(write("a.tif", {.bands = {GDT_Float32}, .no_data = -9999.0}, height)));
  ASSERT_TRUE(read) << to_string(read.issues.front());
  EXPECT_TRUE(read->is_terrain);
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(4 * (y * 40 + x)); };
  EXPECT_EQ(read->rgba[at(3, 3) + 3], 0);
  EXPECT_EQ(read->rgba[at(10, 10) + 3], 255);
  EXPECT_GT(read->rgba[at(24, 10)], read->rgba[at(12, 10)] + 40);  // rising east faces the light, falling does not
}

TEST_F(RasterFiles, ASystemNeedsAGeoreferenceAndGoesThroughIt) {
  const std::string file = write("a.tif", {.left = 500000.0, .top = 5400030.0, .epsg = 32633}, [](int, int, int) { return 99; });
  expect_refusal(read_raster_underlay(local(file)), "does not know where it lies");
  UnderlayRequest request = local(file);
  request.georeference.kind = GeoreferenceKind::anchor;
  request.georeference.origin = {48.752926, 15.0, 290.0};
  request.georeference.azimuth_deg = 30.0;
  request.area_in_reference_m = {Eigen::Vector2d(-300.0, -300.0), Eigen::Vector2d(300.0, 300.0)};
  const auto read = read_raster_underlay(request);
  ASSERT_TRUE(read) << to_string(read.issues.front());
  const Eigen::Vector2d& corner = read->node_m(0, 0);
  const auto utm = utm_from_geodetic(geodetic_from_reference(request.georeference, {corner.x(), corner.y(), 0.0}), request.georeference.origin);
  ASSERT_TRUE(utm);
  EXPECT_NEAR(utm->easting_m, 500000.0, 0.02);
  EXPECT_NEAR(utm->northing_m, 5400030.0, 0.02);
  EXPECT_NEAR(read->pixel_m, 1.0, 0.01);
  EXPECT_NE(read->system.find("33N"), std::string::npos);
}

TEST_F(RasterFiles, BrokenFilesAreRefusedInWords) {
  std::ofstream(path("a.tif"), std::ios::binary) << "II*\0 no picture";
  expect_refusal(read_raster_underlay(local(path("a.tif"))), "no image that can be read");
  expect_refusal(read_raster_underlay(local(path("absent.png"))), "no image that can be read");
  const std::string file = write("b.tif", {.width = 400, .height = 300}, [](int x, int y, int band) { return (x * 7 + y * 13 + band) % 251; });
  fs::resize_file(file, fs::file_size(file) / 2);
  UnderlayRequest request = local(file);
  request.area_in_reference_m = {Eigen::Vector2d(-1000.0, -1000.0), Eigen::Vector2d(1000.0, 1000.0)};
  expect_refusal(read_raster_underlay(request), "");
  std::ofstream(path("c.png"), std::ios::binary) << "\x89PNG\r\n\x1a\n";
  expect_refusal(read_raster_underlay(local(path("c.png"))), "no image that can be read");
  const auto empty = read_raster_underlay(local(write("d.tif", {.bands = {GDT_Float32}, .no_data = -1.0}, [](int, int, int) { return -1.0; })));
  expect_refusal(empty, "no data around the stems");
}

TEST_F(RasterFiles, ReadingStopsWhenItIsCancelled) {
  const std::string file = write("a.tif", {}, [](int, int, int) { return 1; });
  const std::atomic<bool> cancel{true};
  EXPECT_THROW((void)read_raster_underlay(local(file), Progress({}, &cancel)), Cancelled);
}

}  // namespace
}  // namespace stemwise
