#include "io/geoid_grid.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/geodesy/azimuth.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

/// A grid of a tenth of a degree about 48 N, 9 E: 40 m, rising by 1 m per degree to the east.
std::string write_grid(const fs::path& path) {
  GDALAllRegister();
  GDALDataset* grid = GetGDALDriverManager()->GetDriverByName("GTX")->Create(path.c_str(), 21, 21, 1, GDT_Float32, nullptr);
  double transform[6] = {8.0 - 0.05, 0.1, 0.0, 49.0 + 0.05, 0.0, -0.1};
  grid->SetGeoTransform(transform);
  std::vector<float> values;
  for (int row = 0; row < 21; ++row)
    for (int column = 0; column < 21; ++column) values.push_back(40.0f + 0.1f * static_cast<float>(column));
  EXPECT_EQ(grid->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 21, 21, values.data(), 21, 21, GDT_Float32, 0, 0), CE_None);
  GDALClose(grid);
  return path.string();
}

TEST(GeoidGrid, GivesTheGridsHeightAndItsSlope) {
  const fs::path path = fs::path(testing::TempDir()) / ("geoid-" + std::to_string(::getpid()) + ".gtx");
  const auto geoid = local_geoid_of_grid(write_grid(path), {48.0, 9.0, 0.0});
  ASSERT_TRUE(geoid) << to_string(geoid.issues.front());
  EXPECT_NEAR(geoid->height_m, 41.0, 1e-4);
  EXPECT_NEAR(geoid->slope_east, 1.0 / 74'630.0, 2e-7);  // a degree of longitude at 48 N is 74.63 km
  EXPECT_NEAR(geoid->slope_north, 0.0, 2e-7);
  const auto outside = local_geoid_of_grid(path.string(), {-20.0, 9.0, 0.0});
  ASSERT_FALSE(outside);
  EXPECT_NE(outside.issues.front().text.find("does not cover"), std::string::npos);
  fs::remove(path);
}

TEST(GeoidGrid, AMissingGridIsAClearError) {
  const auto geoid = local_geoid_of_grid("/nowhere/geoid.gtx", {48.0, 9.0, 0.0});
  ASSERT_FALSE(geoid);
  EXPECT_EQ(geoid.issues.front().file, "/nowhere/geoid.gtx");
}

TEST(GeoidGrid, GridConvergenceIsThatOfUtmAndNothingForDegrees) {
  const Geodetic at{48.0, 11.0, 0.0};
  EXPECT_NEAR(*grid_convergence_deg(32632, at), *utm_convergence_deg(at), 1e-4);
  EXPECT_FALSE(grid_convergence_deg(4326, at));
}

}  // namespace
}  // namespace stemwise
