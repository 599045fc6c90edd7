#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "io/project_file.hpp"
#include "tests/io/sample_project.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
using Dataset = std::unique_ptr<GDALDataset, void (*)(GDALDataset*)>;

Dataset open(const std::string& path, unsigned flags = GDAL_OF_VECTOR) {
  const char* const options[] = {"LIST_ALL_TABLES=YES", nullptr};
  return {GDALDataset::Open(path.c_str(), flags, nullptr, options, nullptr), [](GDALDataset* d) { GDALClose(d); }};
}

class KeepLayersTest : public testing::Test {
 protected:
  void SetUp() override {
    GDALAllRegister();
    path_ = (fs::path(testing::TempDir()) / ("keep-" + std::to_string(::getpid()) + ".gpkg")).string();
    ASSERT_TRUE(write_project(sample_project(), path_));
  }
  void TearDown() override { fs::remove(path_); }

  /// What a person does in QGIS: a layer of skid trails, a plain table, a style of their own for the trees.
  void add_by_hand() {
    const Dataset file = open(path_, GDAL_OF_VECTOR | GDAL_OF_UPDATE);
    OGRSpatialReference utm;
    utm.importFromEPSG(32756);
    OGRLayer* trails = file->CreateLayer("skid trails", &utm, wkbLineString, nullptr);
    OGRFieldDefn width("width_m", OFTReal);
    ASSERT_EQ(trails->CreateField(&width), OGRERR_NONE);
    OGRFeature trail(trails->GetLayerDefn());
    trail.SetField(0, 3.5);
    OGRLineString line;
    line.addPoint(480000.125, 6945000.25);
    line.addPoint(480100.5, 6945050.75);
    trail.SetGeometry(&line);
    trail.SetFID(41);
    ASSERT_EQ(trails->CreateFeature(&trail), OGRERR_NONE);
    OGRLayer* notes = file->CreateLayer("notes", nullptr, wkbNone, nullptr);
    OGRFieldDefn text("text", OFTString);
    ASSERT_EQ(notes->CreateField(&text), OGRERR_NONE);
    OGRFeature note(notes->GetLayerDefn());
    note.SetField(0, "Käfer am Weg");
    ASSERT_EQ(notes->CreateFeature(&note), OGRERR_NONE);
    OGRLayer* styles = file->GetLayerByName("layer_styles");
    ASSERT_NE(styles, nullptr);
    OGRFeature style(styles->GetLayerDefn());
    style.SetField("f_table_name", "trees");
    style.SetField("styleName", "anna's");
    style.SetField("styleQML", "<qgis/>");
    style.SetField("useAsDefault", 1);
    style.SetField("owner", "anna");
    ASSERT_EQ(styles->CreateFeature(&style), OGRERR_NONE);
  }
  std::string path_;
};

TEST_F(KeepLayersTest, WhatAPersonAddedToTheProjectFileOutlivesEverySave) {
  add_by_hand();
  for (int save = 0; save < 2; ++save) {
    const auto state = read_project(path_);
    ASSERT_TRUE(state);
    const auto done = write_project(*state, path_);
    ASSERT_TRUE(done) << to_string(done.issues.front());
    EXPECT_TRUE(done.issues.empty());
  }
  EXPECT_EQ(*read_project(path_), sample_project());
  const Dataset file = open(path_);
  OGRLayer* trails = file->GetLayerByName("skid trails");
  ASSERT_NE(trails, nullptr);
  EXPECT_STREQ(trails->GetSpatialRef()->GetAuthorityCode(nullptr), "32756");
  const std::unique_ptr<OGRFeature> trail(trails->GetFeature(41));
  ASSERT_NE(trail, nullptr);
  EXPECT_EQ(trail->GetFieldAsDouble("width_m"), 3.5);
  EXPECT_EQ(trail->GetGeometryRef()->toLineString()->getX(1), 480100.5);
  OGRLayer* notes = file->GetLayerByName("notes");
  ASSERT_NE(notes, nullptr);
  const std::unique_ptr<OGRFeature> note(notes->GetNextFeature());
  EXPECT_STREQ(note->GetFieldAsString("text"), "Käfer am Weg");
}

TEST_F(KeepLayersTest, LayersCarryAStyleAndAPersonsOwnStaysTheDefault) {
  add_by_hand();
  ASSERT_TRUE(write_project(sample_project(), path_));
  const Dataset file = open(path_);
  OGRLayer* styles = file->GetLayerByName("layer_styles");
  ASSERT_NE(styles, nullptr);
  int ours = 0, annas = 0;
  for (const auto& feature : *styles) {
    const std::string table = feature->GetFieldAsString("f_table_name");
    const bool is_default = feature->GetFieldAsInteger("useAsDefault") != 0;
    if (std::string(feature->GetFieldAsString("styleName")) == "anna's") {
      ++annas;
      EXPECT_TRUE(is_default);
      continue;
    }
    ++ours;
    EXPECT_EQ(is_default, table != "trees") << table;
    EXPECT_THAT(feature->GetFieldAsString("styleQML"), testing::HasSubstr("<renderer-v2"));
    if (table == "trees") {
      EXPECT_THAT(feature->GetFieldAsString("styleQML"), testing::HasSubstr("value=\"outside_coverage\""));
    }
  }
  EXPECT_EQ(annas, 1);
  EXPECT_EQ(ours, 4);  // trees, observations, links, coverage
}

}  // namespace
}  // namespace stemwise
