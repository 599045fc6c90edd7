#include "io/export_layer.hpp"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/crs.hpp"
#include "tests/io/sample_project.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ExportLayerTest : public testing::Test {
 protected:
  void SetUp() override {
    GDALAllRegister();
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("stemwise-" + std::to_string(::getpid()) + "-" + info->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string bytes(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  std::string first_line(const std::string& name) const {
    const std::string text = bytes(name);
    return text.substr(0, text.find('\n'));
  }
  std::size_t files_left() const {
    std::size_t n = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++n;
    return n;
  }
  fs::path folder_;
  ProjectState state_ = sample_project();
};

ProjectState without_georeference() {
  ProjectState state = sample_project();
  state.georeference = {};
  return state;
}

TEST_F(ExportLayerTest, CsvHasTheColumnsOfTheContract) {
  const auto header_of = [&](LayerKind kind) {
    ExportOptions options;
    options.layer = kind;
    const auto done = export_layer(state_, path("e.csv"), options);
    EXPECT_TRUE(done) << to_string(done.issues.front());
    return first_line("e.csv");
  };
  EXPECT_EQ(header_of(LayerKind::trees),
            "tree_id,x,y,z,lon,lat,height,position_sd_m,dbh_cm,dbh_source,species,fate,first_seen,last_seen,times_seen,dbh_2019_cm,dbh_2023_cm,"
            "growth_cm_per_year,flags,note,edited_by");
  EXPECT_EQ(header_of(LayerKind::observations), "tree_id,inventory,source_id,x,y,z,dbh_cm,dbh_error_cm,fate,residual_m,confidence,flags");
  const std::string matches =
      "tree_id,inventory_a,source_id_a,inventory_b,source_id_b,distance_m,dbh_a_cm,dbh_b_cm,dbh_change_cm,years,growth_cm_per_year,change_class,"
      "confidence,state,flags";
  EXPECT_EQ(header_of(LayerKind::matches), matches);
  EXPECT_EQ(header_of(LayerKind::links), matches);
  EXPECT_EQ(header_of(LayerKind::inventories), "name,date,trees,status,overlap,residual,pose");
  EXPECT_EQ(header_of(LayerKind::coverage), "inventory,area_ha,source,wkt");
}

TEST_F(ExportLayerTest, EveryFormatIsReadBackByGdalWithEveryTree) {
  const auto trees = static_cast<GIntBig>(derive_tables(state_).trees.size());
  for (const std::string suffix : {".gpkg", ".geojson", ".csv", ".tsv", ".shp", ".fgb", ".kml", ".kmz", ".gpx", ".dxf", ".xlsx", ".ods"}) {
    const std::string file = path("out" + suffix);
    const auto done = export_layer(state_, file);
    ASSERT_TRUE(done) << suffix << ": " << to_string(done.issues.front());
    auto* dataset = GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR);
    ASSERT_NE(dataset, nullptr) << suffix;
    OGRLayer* layer = suffix == ".gpx" ? dataset->GetLayerByName("waypoints") : dataset->GetLayer(0);
    ASSERT_NE(layer, nullptr) << suffix;
    EXPECT_EQ(layer->GetFeatureCount(), trees) << suffix;
    GDALClose(dataset);
  }
}

TEST_F(ExportLayerTest, CoordinatesInTheUtmZoneAreTheAnchorsWithinAMillimetre) {
  ASSERT_TRUE(export_layer(state_, path("t.gpkg")));
  auto* dataset = GDALDataset::Open(path("t.gpkg").c_str(), GDAL_OF_VECTOR);
  OGRLayer* layer = dataset->GetLayerByName("trees");
  EXPECT_STREQ(layer->GetSpatialRef()->GetAuthorityCode(nullptr), "32756");
  const Tables tables = derive_tables(state_);
  std::size_t i = 0;
  std::size_t near = 0;
  for (const auto& feature : *layer) {
    const OGRPoint* p = feature->GetGeometryRef()->toPoint();
    const auto g = geodetic_from_reference(state_.georeference, tables.trees[i].position_m);
    const auto utm = utm_from_geodetic(g, state_.georeference.origin);  // GeographicLib against PROJ
    ++i;
    if (!utm) continue;  // the sample has one stem thousands of kilometres off
    ++near;
    EXPECT_NEAR(p->getX(), utm->easting_m, 1e-3);
    EXPECT_NEAR(p->getY(), utm->northing_m, 1e-3);
    EXPECT_NEAR(feature->GetFieldAsDouble("x"), utm->easting_m, 1e-3);
    EXPECT_NEAR(feature->GetFieldAsDouble("lat"), g.latitude_deg, 1e-9);
  }
  EXPECT_EQ(i, tables.trees.size());
  EXPECT_GE(near + 1, i);
  GDALClose(dataset);
}

TEST_F(ExportLayerTest, GeoJsonIsLongitudeAndLatitudeWithinAMillimetre) {
  ASSERT_TRUE(export_layer(state_, path("t.geojson")));
  auto* dataset = GDALDataset::Open(path("t.geojson").c_str(), GDAL_OF_VECTOR);
  OGRLayer* layer = dataset->GetLayer(0);
  const auto to_utm = CrsTransform::between(wgs84_epsg, 32756);
  for (const auto& feature : *layer) {
    const OGRPoint* p = feature->GetGeometryRef()->toPoint();
    const auto back = (*to_utm)({p->getX(), p->getY(), 0.0});
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->x(), feature->GetFieldAsDouble("x"), 1e-3);
    EXPECT_NEAR(back->y(), feature->GetFieldAsDouble("y"), 1e-3);
  }
  GDALClose(dataset);
}

TEST_F(ExportLayerTest, AGivenSystemIsUsed) {
  ExportOptions options;
  options.epsg = 28356;  // GDA94 / MGA zone 56
  ASSERT_TRUE(export_layer(state_, path("t.gpkg"), options));
  auto* dataset = GDALDataset::Open(path("t.gpkg").c_str(), GDAL_OF_VECTOR);
  EXPECT_STREQ(dataset->GetLayerByName("trees")->GetSpatialRef()->GetAuthorityCode(nullptr), "28356");
  GDALClose(dataset);
  options.epsg = 999999;
  EXPECT_FALSE(export_layer(state_, path("u.gpkg"), options));
}

TEST_F(ExportLayerTest, WithoutAGeoreferenceCoordinatesAreLocalAndMapFormatsAreRefusedWithTheReason) {
  const ProjectState state = without_georeference();
  ASSERT_TRUE(export_layer(state, path("t.csv")));
  ASSERT_TRUE(export_layer(state, path("t.gpkg")));
  for (const char* name : {"t.geojson", "t.kml", "t.gpx"}) {
    const auto done = export_layer(state, path(name));
    ASSERT_FALSE(done) << name;
    EXPECT_THAT(done.issues.front().text, HasSubstr("georeference")) << name;
    EXPECT_FALSE(fs::exists(path(name)));
  }
  ExportOptions options;
  options.epsg = 32756;
  EXPECT_FALSE(export_layer(state, path("u.csv"), options));
  auto* dataset = GDALDataset::Open(path("t.gpkg").c_str(), GDAL_OF_VECTOR);
  const auto* system = dataset->GetLayerByName("trees")->GetSpatialRef();
  EXPECT_TRUE(system == nullptr || system->IsLocal());
  GDALClose(dataset);
}

TEST_F(ExportLayerTest, ARerunGivesTheSameBytes) {
  ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  for (const std::string suffix : {".gpkg", ".geojson", ".csv", ".shp", ".fgb", ".kml", ".gpx", ".dxf"}) {
    ASSERT_TRUE(export_layer(state_, path("a" + suffix)));
    const std::string first = bytes("a" + suffix);
    ASSERT_TRUE(export_layer(state_, path("a" + suffix)));
    EXPECT_TRUE(first == bytes("a" + suffix)) << suffix;
  }
  ::unsetenv("SOURCE_DATE_EPOCH");
}

TEST_F(ExportLayerTest, DecimalCommaAndDelimiterAreAsAsked) {
  ExportOptions options;
  options.decimal_comma = true;
  options.layer = LayerKind::observations;
  ASSERT_TRUE(export_layer(state_, path("t.csv"), options));
  EXPECT_TRUE(bytes("t.csv").starts_with("\xEF\xBB\xBF"));  // without it, Excel takes UTF-8 for Windows-1252
  EXPECT_THAT(first_line("t.csv"), HasSubstr("tree_id;inventory"));
  EXPECT_THAT(bytes("t.csv"), testing::ContainsRegex(";[0-9]+,[0-9]{4};"));
}

TEST_F(ExportLayerTest, ObservationsHaveARowForEveryStemOfEveryInventoryAlsoOfThoseThatWereNotAligned) {
  std::size_t stems = 0, rows = 0;
  for (const auto& inventory : state_.inventories) stems += inventory->stems.size();
  ExportOptions options;
  options.layer = LayerKind::observations;
  ASSERT_TRUE(export_layer(state_, path("o.csv"), options));
  auto* dataset = GDALDataset::Open(path("o.csv").c_str(), GDAL_OF_VECTOR);
  for (const auto& feature : *dataset->GetLayer(0)) {
    ++rows;
    if (std::string(feature->GetFieldAsString("inventory")) != "no date") continue;
    EXPECT_STREQ(feature->GetFieldAsString("tree_id"), "");
    EXPECT_STREQ(feature->GetFieldAsString("x"), "");
    EXPECT_STREQ(feature->GetFieldAsString("fate"), "unresolved");
  }
  EXPECT_EQ(rows, stems);
  GDALClose(dataset);
  EXPECT_TRUE(export_layer(state_, path("o.shp"), options));  // what has no place is left out of a map
}

TEST_F(ExportLayerTest, AnExportOfOneLayerSaysWhatItIsAndAShapefilesNamesAreExplained) {
  ASSERT_TRUE(export_layer(state_, path("t.shp")));
  const std::string about = bytes("t.shp.about.txt");
  for (const char* part : {"EPSG:32756", "seed: 0", "units:", "georeference: control points (4)", "alignment of 2023: aligned, matched 9", "pos_sd_m = position_sd_m:"})
    EXPECT_THAT(about, HasSubstr(part));
}

TEST_F(ExportLayerTest, HeightsAreAboveTheGeoidThatTheGeoreferenceNamesButGeoJsonStaysOnTheEllipsoid) {
  for (const auto& inventory : state_.inventories)
    for (auto& stem : const_cast<Inventory&>(*inventory).stems) stem.z_m = 1.0;
  ASSERT_TRUE(export_layer(state_, path("ellipsoid.csv")));
  ASSERT_TRUE(export_layer(state_, path("ellipsoid.geojson")));
  state_.georeference.geoid = {"test geoid", 40.0, 0.0, 0.0};
  ASSERT_TRUE(export_layer(state_, path("geoid.csv")));
  ASSERT_TRUE(export_layer(state_, path("geoid.geojson")));
  const auto first = [&](const char* file, const char* column) {
    auto* dataset = GDALDataset::Open(path(file).c_str(), GDAL_OF_VECTOR);
    const std::unique_ptr<OGRFeature> feature(dataset->GetLayer(0)->GetNextFeature());
    const double value = column == nullptr ? feature->GetGeometryRef()->toPoint()->getZ() : feature->GetFieldAsDouble(column);
    GDALClose(dataset);
    return value;
  };
  EXPECT_NEAR(first("ellipsoid.csv", "height") - first("geoid.csv", "height"), 40.0, 1e-3);
  EXPECT_NEAR(first("ellipsoid.csv", "z") - first("geoid.csv", "z"), 40.0, 1e-3);
  EXPECT_NEAR(first("ellipsoid.geojson", nullptr), first("geoid.geojson", nullptr), 1e-3);
}

TEST_F(ExportLayerTest, ForestGeoTablesHaveARowPerTreeAndCensusInMillimetres) {
  ExportOptions options;
  options.layer = LayerKind::forestgeo;
  ASSERT_TRUE(export_layer(state_, path("f.csv"), options));
  EXPECT_EQ(first_line("f.csv"), "treeID,stemID,tag,StemTag,sp,quadrat,gx,gy,dbh,hom,ExactDate,CensusID,status,codes");
  auto* dataset = GDALDataset::Open(path("f.csv").c_str(), GDAL_OF_VECTOR);
  const Tables tables = derive_tables(state_);
  std::size_t alive_or_dead = 0;
  for (const auto& feature : *dataset->GetLayer(0)) {
    const std::string status = feature->GetFieldAsString("status");
    EXPECT_THAT(status, testing::AnyOf("A", "D", "M"));
    alive_or_dead += *feature->GetFieldAsString("StemTag") != 0 ? 1 : 0;
    EXPECT_GE(std::atof(feature->GetFieldAsString("gx")), 0.0);
  }
  EXPECT_EQ(alive_or_dead, tables.observations.size());
  GDALClose(dataset);
}

TEST_F(ExportLayerTest, WhatCannotBeWrittenIsAFailureAndLeavesNothing) {
  for (const std::string suffix : {".gpkg", ".geojson", ".csv", ".shp", ".fgb", ".kml", ".xlsx", ".dxf", ".what"}) {
    EXPECT_FALSE(export_layer(state_, path("no/such/folder/t" + suffix))) << suffix;
  }
  fs::create_directories(path("taken.csv"));
  EXPECT_FALSE(export_layer(state_, path("taken.csv")));
  EXPECT_EQ(files_left(), 1U);
}

TEST_F(ExportLayerTest, LayersWithoutAPlaceAreRefusedByFlatGeobufAndNotLost) {
  for (const LayerKind kind : {LayerKind::matches, LayerKind::inventories, LayerKind::forestgeo}) {
    ExportOptions options;
    options.layer = kind;
    const auto done = export_layer(state_, path("e.fgb"), options);
    ASSERT_FALSE(done);
    EXPECT_THAT(to_string(done.issues.front()), HasSubstr("has no geometry"));
  }
  EXPECT_EQ(files_left(), 0U);
}

TEST_F(ExportLayerTest, RowsWithoutAPlaceAreNamedWhereTheFormatCannotHoldThem) {
  ExportOptions options;
  options.layer = LayerKind::observations;
  for (const char* name : {"o.fgb", "o.shp", "o.gpx"}) {
    const auto done = export_layer(state_, path(name), options);
    ASSERT_TRUE(done) << to_string(done.issues.front());
    ASSERT_EQ(done.issues.size(), 1U) << name;
    EXPECT_THAT(to_string(done.issues[0]), HasSubstr("no place on the map"));
  }
}

TEST_F(ExportLayerTest, GpxWaypointsHaveTheTreesNameAndItsHeightWhereOneIsKnown) {
  ASSERT_TRUE(export_layer(state_, path("t.gpx")));
  const std::string gpx = bytes("t.gpx");
  const Tables tables = derive_tables(state_);
  const auto count = [&](const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = gpx.find(what); at != std::string::npos; at = gpx.find(what, at + 1)) ++n;
    return n;
  };
  const auto with_height = static_cast<std::size_t>(std::count_if(tables.trees.begin(), tables.trees.end(), [](const TreeRow& t) { return t.has_z; }));
  EXPECT_EQ(count("<wpt"), tables.trees.size());
  EXPECT_EQ(count("<name>T-"), tables.trees.size());
  EXPECT_EQ(count("<ele>"), with_height);
  EXPECT_EQ(count("<ele>0.0</ele>"), 0U);
  ASSERT_GT(with_height, 0U);
}

TEST_F(ExportLayerTest, AFullDiskLeavesNothingOfAShapefile) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 600;  // room for the .cpg, not for the .dbf
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto done = export_layer(state_, path("x.shp"));
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(done);
  EXPECT_EQ(files_left(), 0U);
}

TEST_F(ExportLayerTest, ShortColumnNamesStayUnique) {
  auto* dataset = (export_layer(state_, path("t.shp")), GDALDataset::Open(path("t.shp").c_str(), GDAL_OF_VECTOR));
  ASSERT_NE(dataset, nullptr);
  std::set<std::string> names;
  auto* definition = dataset->GetLayer(0)->GetLayerDefn();
  for (int i = 0; i < definition->GetFieldCount(); ++i) names.insert(definition->GetFieldDefn(i)->GetNameRef());
  EXPECT_EQ(static_cast<int>(names.size()), definition->GetFieldCount());
  EXPECT_EQ(definition->GetFieldCount(), 21);
  GDALClose(dataset);
}

}  // namespace
}  // namespace stemwise
