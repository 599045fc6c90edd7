#include "io/underlay/read_cloud_underlay.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "las_file.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
using test::LasFile;

class CloudFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) / ("cloud-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  /// Local coordinates, stems between 0 and 20 m.
  static UnderlayRequest local(const std::string& file) {
    return {file, {}, {}, Eigen::AlignedBox2d(Eigen::Vector2d(-10.0, -10.0), Eigen::Vector2d(30.0, 30.0))};
  }
  /// Stems whose coordinates are UTM 33N.
  static UnderlayRequest on_earth(const std::string& file) {
    UnderlayRequest request{file, {}, {}, Eigen::AlignedBox2d(Eigen::Vector2d(499990.0, 5399990.0), Eigen::Vector2d(500030.0, 5400030.0))};
    request.georeference.kind = GeoreferenceKind::crs;
    request.georeference.epsg = 32633;
    return request;
  }

  static Eigen::Vector3d place(const CloudUnderlay& cloud, std::size_t i) {
    const CloudPoint& p = cloud.points.at(i);
    return cloud.origin_in_reference_m + Eigen::Vector3d(p.x_m, p.y_m, p.z_m);
  }
  static void expect_refusal(const Result<CloudUnderlay>& read, const std::string& words) {
    ASSERT_FALSE(read);
    ASSERT_FALSE(read.issues.empty());
    const Issue& issue = read.issues.front();
    EXPECT_NE(issue.text.find(words), std::string::npos) << issue.text;
    EXPECT_FALSE(issue.help.empty());
    EXPECT_FALSE(issue.file.empty());
  }

  fs::path folder_;
};

TEST_F(CloudFiles, AnAsciiPlyIsReadWithItsColours) {
  const std::string file = write("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
                                          "property uchar blue\nend_header\n1 2 0 200 100 50\n5 6 1 1 2 3\n500 6 1 1 2 3\n");
  const auto read = read_cloud_underlay(local(file));
  ASSERT_TRUE(read) << to_string(read.issues.front());
  EXPECT_EQ(read->points_in_file, 3);
  ASSERT_EQ(read->points.size(), 2u);  // one lies away from the stems
  EXPECT_TRUE(read->has_colour);
  EXPECT_FALSE(read->has_intensity);
  for (std::size_t i = 0; i < 2; ++i) {
    if (place(*read, i).x() > 3.0) continue;
    EXPECT_NEAR(place(*read, i).y(), 2.0, 1e-6);
    EXPECT_EQ(read->points[i].red, 200);
    EXPECT_EQ(read->points[i].blue, 50);
  }
}

TEST_F(CloudFiles, ABinaryPlyOfDoublesKeepsMillimetresAtUtmScale) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  for (const double value : {500001.234, 5400002.345, 10.0, 500003.0, 5400004.0, 11.0}) text.append(reinterpret_cast<const char*>(&value), sizeof value);
  UnderlayRequest request = on_earth(write("a.ply", text));
  const auto read = read_cloud_underlay(request);
  ASSERT_TRUE(read) << to_string(read.issues.front());
  ASSERT_EQ(read->points.size(), 2u);
  const std::size_t first = place(*read, 0).x() < 500002.0 ? 0 : 1;
  EXPECT_NEAR(place(*read, first).x(), 500001.234, 0.001);
  EXPECT_NEAR(place(*read, first).y(), 5400002.345, 0.001);
}

TEST_F(CloudFiles, APcdIsReadAndTurnedWithItsSurvey) {
  const std::string file = write("a.pcd", "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ascii\n"
                                          "1 2 3 0.1\n4 5 6 0.9\nnan nan nan 0\n");
  UnderlayRequest request = local(file);
  request.reference_from_local = RigidTransform::planar(10.0, 0.0, radians(90.0));
  const auto read = read_cloud_underlay(request);
  ASSERT_TRUE(read) << to_string(read.issues.front());
  ASSERT_EQ(read->points.size(), 2u);
  EXPECT_TRUE(read->has_intensity);
  const std::size_t first = place(*read, 0).z() < 4.0 ? 0 : 1;
  EXPECT_NEAR((place(*read, first) - Eigen::Vector3d(8.0, 1.0, 3.0)).norm(), 0.0, 1e-5);
}

TEST_F(CloudFiles, LasOfOldAndNewFormatsIsReadWithItsSystem) {
  for (const auto& [minor, format] : {std::pair{2, 1}, {2, 2}, {2, 3}, {3, 5}, {4, 0}, {4, 6}, {4, 7}, {4, 10}}) {
    LasFile las{.minor = minor, .format = format};
    las.name_system(32633);
    las.add(500001.5, 5400002.25, 310.125, 300, 5, 65280);
    las.add(500011.5, 5400012.25, 300.0, 100, 2, 256);
    las.add(500012.5, 5400012.25, 100.0, 100, 7);  // noise
    las.write(path("a.las"));
    const auto read = read_cloud_underlay(on_earth(path("a.las")));
    ASSERT_TRUE(read) << format << ": " << to_string(read.issues.front());
    EXPECT_TRUE(read.issues.empty());
    ASSERT_EQ(read->points.size(), 2u) << format;
    const std::size_t first = place(*read, 0).z() > 305.0 ? 0 : 1;
    EXPECT_NEAR((place(*read, first) - Eigen::Vector3d(500001.5, 5400002.25, 310.125)).norm(), 0.0, 0.001);
    EXPECT_TRUE(read->has_intensity);
    EXPECT_EQ(read->has_colour, format == 2 || format == 3 || format == 5 || format == 7 || format == 10) << format;
    if (read->has_colour) {
      EXPECT_EQ(read->points[first].red, 255);
    }
    EXPECT_NE(read->system.find("33N"), std::string::npos);
  }
}

TEST_F(CloudFiles, LasInAnotherSystemGoesThroughTheGeoreference) {
  LasFile las{.minor = 2, .format = 0};
  las.name_system(32633);
  las.add(500010.0, 5400010.0, 300.0, 1, 1);
  las.write(path("a.las"));
  UnderlayRequest request = local(path("a.las"));
  request.georeference.kind = GeoreferenceKind::anchor;
  request.georeference.origin = {48.752926, 15.0, 290.0};  // 500000, 5400000 or so in zone 33
  request.area_in_reference_m = {Eigen::Vector2d(-500.0, -500.0), Eigen::Vector2d(500.0, 500.0)};
  const auto read = read_cloud_underlay(request);
  ASSERT_TRUE(read) << to_string(read.issues.front());
  const Geodetic there = geodetic_from_reference(request.georeference, place(*read, 0));
  const auto utm = utm_from_geodetic(there, request.georeference.origin);
  ASSERT_TRUE(utm);
  EXPECT_NEAR(utm->easting_m, 500010.0, 0.01);
  EXPECT_NEAR(utm->northing_m, 5400010.0, 0.01);
  EXPECT_NEAR(there.height_m, 300.0, 0.01);
}

TEST_F(CloudFiles, ASystemWithoutAGeoreferenceIsToldWithTheWayOut) {
  LasFile las;
  las.name_system(32633);
  las.add(5.0, 5.0, 0.0, 1, 1);
  las.write(path("a.las"));
  expect_refusal(read_cloud_underlay(local(path("a.las"))), "does not know where it lies");
}

TEST_F(CloudFiles, WithoutASystemCoordinatesAreLocal) {
  LasFile las;
  las.add(500005.0, 5400005.0, 1.0, 1, 1);
  las.write(path("a.las"));
  expect_refusal(read_cloud_underlay(local(path("a.las"))), "lies away from the stems");
  UnderlayRequest request = local(path("a.las"));
  request.area_in_reference_m = on_earth("").area_in_reference_m;
  EXPECT_TRUE(read_cloud_underlay(request));
}

TEST_F(CloudFiles, ACutOffLasGivesWhatIsThereAndSaysSo) {
  LasFile las;
  for (int i = 0; i < 10; ++i) las.add(500000.0 + i, 5400000.0, 0.0, 1, 1);
  std::vector<char> bytes = las.bytes();
  bytes.erase(bytes.end() - (3 * 28 + 5), bytes.end());
  std::ofstream(path("a.las"), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  UnderlayRequest request = on_earth(path("a.las"));
  const auto read = read_cloud_underlay(request);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->points.size(), 6u);
  ASSERT_EQ(read.issues.size(), 1u);
  EXPECT_NE(read.issues[0].text.find("6 of 10"), std::string::npos) << read.issues[0].text;
}

TEST_F(CloudFiles, LazSaysHowToConvertIt) {
  LasFile las{.minor = 2, .format = 3};
  las.add(500000.0, 5400000.0, 0.0, 1, 1);
  std::vector<char> bytes = las.bytes();
  bytes[104] = static_cast<char>(0x80 | 3);
  std::ofstream(path("a.laz"), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const auto read = read_cloud_underlay(on_earth(path("a.laz")));
  expect_refusal(read, "LAZ");
  EXPECT_NE(read.issues[0].help.find("laszip"), std::string::npos);
}

TEST_F(CloudFiles, BrokenFilesAreRefusedInWords) {
  LasFile las;
  las.add(500000.0, 5400000.0, 0.0, 1, 1);
  const std::vector<char> good = las.bytes();
  const auto with = [&](std::size_t at, auto value) {
    std::vector<char> bytes = good;
    LasFile::put(bytes, at, value);
    std::ofstream(path("b.las"), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return on_earth(path("b.las"));
  };
  expect_refusal(read_cloud_underlay(with(0, 'X')), "no LAS file");
  expect_refusal(read_cloud_underlay(with(25, char{9})), "LAS 1.9");
  expect_refusal(read_cloud_underlay(with(104, char{33})), "format 33");
  expect_refusal(read_cloud_underlay(with(105, std::uint16_t{3})), "contradicts itself");
  expect_refusal(read_cloud_underlay(with(131, 0.0)), "contradicts itself");
  std::ofstream(path("c.las"), std::ios::binary).write(good.data(), 100);
  expect_refusal(read_cloud_underlay(on_earth(path("c.las"))), "within its header");
  expect_refusal(read_cloud_underlay(on_earth(path("absent.las"))), "cannot be opened");
  expect_refusal(read_cloud_underlay(local(path("absent.ply"))), "cannot be opened");
  expect_refusal(read_cloud_underlay(local(write("a.ply", "no ply at all"))), "no PLY file");
  expect_refusal(read_cloud_underlay(local(write("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 1000\nproperty float x\nproperty float y\nproperty float z\nend_header\n1234"))), "promises 1000 points");
  expect_refusal(read_cloud_underlay(local(write("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 99999999999\nproperty float x\nproperty float y\nproperty float z\nend_header\n1234"))), "too large");
  expect_refusal(read_cloud_underlay(local(write("a.pcd", "VERSION 0.7\nnonsense"))), "no x");
  expect_refusal(read_cloud_underlay(local(write("b.pcd", "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 500\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 500\nDATA binary\n1234"))), "promises 500 points");
  const std::string packed = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 5\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 5\nDATA binary_compressed\n";
  expect_refusal(read_cloud_underlay(local(write("d.pcd", packed + std::string("\x40\x00\x00\x00\x3c\x00\x00\x00 too short", 18)))), "promises 5 points");
  expect_refusal(read_cloud_underlay(local(write("f.pcd", packed + std::string("\x0a\x00\x00\x00\x3c\x00\x00\x00 unpackable noise", 25)))), "");
  expect_refusal(read_cloud_underlay(local(write("e.ply", "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n"))), "");
}

TEST_F(CloudFiles, ReadingStopsWhenItIsCancelled) {
  LasFile las;
  for (int i = 0; i < 10; ++i) las.add(500000.0 + i, 5400000.0, 0.0, 1, 1);
  las.write(path("a.las"));
  const std::atomic<bool> cancel{true};
  EXPECT_THROW((void)read_cloud_underlay(on_earth(path("a.las")), Progress({}, &cancel)), Cancelled);
}

}  // namespace
}  // namespace stemwise
