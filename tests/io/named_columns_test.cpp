#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/read_control_points.hpp"
#include "io/read_gnss_track.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

std::string written(const std::string& name, const std::string& text) {
  const fs::path path = fs::path(::testing::TempDir()) / name;
  std::ofstream(path) << text;
  return path.string();
}

TEST(NamedColumns, ATrackWithDecimalCommasIsReadAsOneWithPoints) {
  const auto commas = read_gnss_track(written("track_comma.csv", "timestamp;lat;lon;height_m;sd_m\n12,5;48,002067295;8,1;512,25;0,4\n2023-05-04T10:15:00.5Z;48,1;8,2;;\n"));
  const auto points = read_gnss_track(written("track_point.csv", "timestamp,lat,lon,height_m,sd_m\n12.5,48.002067295,8.1,512.25,0.4\n2023-05-04T10:15:00.5Z,48.1,8.2,,\n"));
  ASSERT_TRUE(commas);
  ASSERT_TRUE(points);
  EXPECT_TRUE(commas.issues.empty());
  ASSERT_EQ(commas->size(), points->size());
  for (std::size_t i = 0; i < points->size(); ++i) {
    EXPECT_EQ((*commas)[i].timestamp_s, (*points)[i].timestamp_s);
    EXPECT_EQ((*commas)[i].on_earth.latitude_deg, (*points)[i].on_earth.latitude_deg);
    EXPECT_EQ((*commas)[i].on_earth.longitude_deg, (*points)[i].on_earth.longitude_deg);
    EXPECT_EQ((*commas)[i].on_earth.height_m, (*points)[i].on_earth.height_m);
    EXPECT_EQ((*commas)[i].sd_m, (*points)[i].sd_m);
  }
}

TEST(NamedColumns, WhatIsNoNumberIsNamedWithRowAndColumnInBothStyles) {
  const auto track = read_gnss_track(written("track_bad.csv", "timestamp;lat;lon\n1;48,5;8,5\n2;48,5,1;8,5\n3;48,6;8,6\n"));
  ASSERT_TRUE(track);
  EXPECT_EQ(track->size(), 2u);
  ASSERT_EQ(track.issues.size(), 1u);
  EXPECT_EQ(track.issues.front().row, 3);
  EXPECT_EQ(track.issues.front().column, "lat");
}

}  // namespace
}  // namespace stemwise
