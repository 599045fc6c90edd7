#include "io/read_frame_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "io/parse_decimal.hpp"
#include "io/read_frame_file.hpp"
#include "io/scan_decimal.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

constexpr const char* header =
    "axis_00,axis_01,axis_02,axis_10,axis_11,axis_12,axis_20,axis_21,axis_22,location_x,location_y,location_z,dbh,dbh_"
    "approximation,score,"
    "reconstructed,number_clusters\n";
constexpr const char* good_row = "1,0,0,0,1,0,0,0,1,2.5,-3.25,0.5,0.31,0.3,0.9,True,4\n";
constexpr const char* pose_line = "10.0 1 2 3 0 0 0 1\n";

class ReadFrameFolder : public ::testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("stemwise_frames_" + std::to_string(::getpid()) + "_" +
                                           ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name, std::ios::binary) << text; }
  std::string path() const { return folder_.string(); }

  fs::path folder_;
};

bool names(const Issues& issues, const std::string& file, std::int64_t row, const std::string& column) {
  return std::any_of(issues.begin(), issues.end(), [&](const Issue& i) {
    return i.file.find(file) != std::string::npos && i.row == row && i.column.find(column) != std::string::npos;
  });
}

TEST_F(ReadFrameFolder, ReadsStemsPosesAndNumbersOfGoodFrames) {
  write("trajectory.txt", std::string("# timestamp x y z qx qy qz qw\n") + pose_line + pose_line);
  write("TreeManagerState_0.csv", std::string(header) + good_row);
  write("TreeManagerState_1.csv", std::string(header) + good_row + good_row);
  const auto read = read_frame_folder(path());
  ASSERT_TRUE(read);
  EXPECT_TRUE(read.issues.empty());
  ASSERT_EQ(read->frames->frames.size(), 2U);
  EXPECT_EQ(read->frames->frames[1].stems.size(), 2U);
  const Stem& stem = read->frames->frames[0].stems[0];
  EXPECT_EQ(stem.x_m, 2.5);
  EXPECT_EQ(stem.y_m, -3.25);
  EXPECT_EQ(stem.z_m, 0.5);
  EXPECT_EQ(stem.dbh_m, 0.31);
  EXPECT_EQ(stem.number_clusters, 4);
  EXPECT_TRUE(stem.reconstructed);
  EXPECT_EQ(stem.source_row, 2);
  EXPECT_EQ(read->frames->frames[0].pose.survey_from_frame.translation_m, Eigen::Vector3d(1, 2, 3));
}

TEST_F(ReadFrameFolder, FindsColumnsByHeaderInAnyOrderAndCase) {
  write("trajectory.txt", pose_line);
  write("TreeManagerState_0.csv", "Scores;DBH_approximation;LOCATION_Y;other;location_x\r\n0.5;0.2;7;x;8\r\n");
  const auto read = read_frame_folder(path());
  ASSERT_TRUE(read);
  const Stem& stem = read->frames->frames[0].stems.at(0);
  EXPECT_EQ(stem.x_m, 8.0);
  EXPECT_EQ(stem.y_m, 7.0);
  EXPECT_EQ(stem.score, 0.5);
  EXPECT_EQ(stem.dbh_approximation_m, 0.2);
  EXPECT_FALSE(stem.dbh_m || stem.z_m || stem.axis);
}

TEST_F(ReadFrameFolder, NamesEveryBadRowAndKeepsTheGoodOnes) {
  write("trajectory.txt", pose_line);
  write("TreeManagerState_0.csv", std::string(header) + good_row + "1,0,0,0,1,0,0,0,1,2.5,oak,0.5,0.31,0.3,0.9,True,4\n" +
                                      "1,0,0,0,1,0,0,0,1,2.5,1,nan,0.31,0.3,0.9,True,4\n" + "1,0,0,0,1,0,0,0\n" +
                                      "1,0,0,0,1,0,0,0,1,2.5,1,0,-0.31,0.3,0.9,True,4\n" +
                                      "1,0,0,0,1,0,0,0,3,2.5,1,0,0.31,0.3,0.9,True,4\n" +
                                      "1,0,0,0,1,0,0,0,1,,1,0,0.31,0.3,0.9,perhaps,4\n" + good_row);
  const auto read = read_frame_folder(path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->frames->frames[0].stems.size(), 2U);
  EXPECT_EQ(read.issues.size(), 6U);
  EXPECT_TRUE(names(read.issues, "TreeManagerState_0.csv", 3, "location_y"));
  EXPECT_TRUE(names(read.issues, "TreeManagerState_0.csv", 4, "location_z"));
  EXPECT_TRUE(names(read.issues, "TreeManagerState_0.csv", 5, ""));
  EXPECT_TRUE(names(read.issues, "TreeManagerState_0.csv", 6, "dbh"));
  EXPECT_TRUE(names(read.issues, "TreeManagerState_0.csv", 7, "axis"));
  EXPECT_TRUE(names(read.issues, "TreeManagerState_0.csv", 8, "reconstructed"));
}

TEST_F(ReadFrameFolder, RefusesAFolderWithoutTrajectory) {
  write("TreeManagerState_0.csv", std::string(header) + good_row);
  const auto read = read_frame_folder(path());
  EXPECT_FALSE(read);
  EXPECT_TRUE(has_error(read.issues));
  EXPECT_TRUE(names(read.issues, "trajectory.txt", 0, ""));
}

TEST_F(ReadFrameFolder, RefusesAFolderWithoutFramesAndOneThatIsNone) {
  write("trajectory.txt", pose_line);
  EXPECT_FALSE(read_frame_folder(path()));
  EXPECT_FALSE(read_frame_folder(path() + "/nowhere"));
  EXPECT_FALSE(is_frame_folder(path() + "/nowhere"));
  EXPECT_TRUE(is_frame_folder(path()));
}

TEST_F(ReadFrameFolder, ReadsWhatFitsWhenTheTrajectoryIsShorterThanTheFrames) {
  write("trajectory.txt", pose_line);
  for (const char* name : {"TreeManagerState_0.csv", "TreeManagerState_1.csv", "TreeManagerState_2.csv"})
    write(name, std::string(header) + good_row);
  const auto read = read_frame_folder(path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->frames->frames.size(), 1U);
  EXPECT_TRUE(names(read.issues, "TreeManagerState_1.csv", 0, ""));
  EXPECT_TRUE(names(read.issues, "TreeManagerState_2.csv", 0, ""));
}

TEST_F(ReadFrameFolder, ABadTrajectoryLineCostsOnlyItsOwnFrame) {
  write("trajectory.txt", std::string(pose_line) + "11.0 1 2 x 0 0 0 1\n" + pose_line);
  for (const char* name : {"TreeManagerState_0.csv", "TreeManagerState_1.csv", "TreeManagerState_2.csv"})
    write(name, std::string(header) + good_row);
  const auto read = read_frame_folder(path());
  ASSERT_TRUE(read);
  ASSERT_EQ(read->frames->frames.size(), 2U);
  EXPECT_EQ(read->frames->frames[1].number, 2);
  EXPECT_TRUE(names(read.issues, "trajectory.txt", 2, "z"));
  EXPECT_TRUE(names(read.issues, "TreeManagerState_1.csv", 0, ""));
}

TEST_F(ReadFrameFolder, NamesTruncatedAndEmptyFrameFiles) {
  write("trajectory.txt", std::string(pose_line) + pose_line + pose_line);
  write("TreeManagerState_0.csv", std::string(header) + good_row + std::string(good_row).substr(0, 25));
  write("TreeManagerState_1.csv", "");
  const auto read = read_frame_folder(path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->frames->frames.size(), 1U);
  EXPECT_EQ(read->frames->frames[0].stems.size(), 1U);
  EXPECT_TRUE(names(read.issues, "TreeManagerState_0.csv", 3, ""));
  EXPECT_TRUE(names(read.issues, "TreeManagerState_1.csv", 1, "location_x"));
  EXPECT_TRUE(std::any_of(read.issues.begin(), read.issues.end(),
                          [](const Issue& i) { return i.text.find("no frame file: 2") != std::string::npos; }));
}

TEST_F(ReadFrameFolder, TakesADateOnlyFromPlausibleTimeStamps) {
  write("TreeManagerState_0.csv", std::string(header) + good_row);
  write("trajectory.txt", "1697617761.6 1 2 3 0 0 0 1\n");
  EXPECT_EQ(read_frame_folder(path())->date, date_from_civil(2023, 10, 18));
  write("trajectory.txt", pose_line);
  EXPECT_FALSE(read_frame_folder(path())->date);
}

/// Rows of all kinds, good and bad, from pieces that a parser may stumble over.
std::vector<std::string> messy_rows() {
  const std::vector<std::string> fields = {"0.5",
                                           "-12.345678",
                                           "7",
                                           "+3",
                                           "1e-3",
                                           "",
                                           " 2 ",
                                           ".5",
                                           "5.",
                                           "-",
                                           ".",
                                           "nan",
                                           "1.2.3",
                                           "oak",
                                           "True",
                                           "false",
                                           "Tru",
                                           "\t1",
                                           "123456789012345678",
                                           "0.1234567890123456",
                                           "-0",
                                           "00.25",
                                           "\"1\""};
  const std::string good = std::string(good_row).substr(0, std::string(good_row).size() - 1);
  std::vector<std::string> rows = {
      good, "", "   ", ",", good + ",", good + ",9", good.substr(0, 20), good.substr(0, good.size() - 2)};
  for (int column = 0; column < 17; ++column) {
    for (const std::string& field : fields) {
      std::string row;
      std::size_t at = 0;
      for (int c = 0; c < 17; ++c) {
        const std::size_t end = std::min(good.find(',', at), good.size());
        row += (c > 0 ? "," : "") + (c == column ? field : good.substr(at, end - at));
        at = end + 1;
      }
      rows.push_back(row);
    }
  }
  return rows;
}

TEST_F(ReadFrameFolder, ReadsACleanRowFastAndEveryRowAsTheCarefulPathDoes) {
  const auto read_rows = [&](const std::string& behind_each_row, const std::string& at_the_end) {
    std::string text = header;
    for (const std::string& row : messy_rows()) text += row + behind_each_row + "\n";
    write("TreeManagerState_0.csv", text + good_row + at_the_end);
    return read_frame_file((folder_ / "TreeManagerState_0.csv").string());
  };
  const auto fast = read_rows("", "");
  const auto careful = read_rows(" ", "");  // a blank behind the last field is none of the fast path's business
  ASSERT_TRUE(fast && careful);
  EXPECT_GT(fast->size(), 200U);
  EXPECT_GT(fast.issues.size(), 60U);
  EXPECT_EQ(*fast, *careful);
  EXPECT_EQ(fast.issues, careful.issues);
  EXPECT_EQ(*fast, *read_rows("\r", ""));
  EXPECT_EQ(fast->back().source_row, static_cast<std::int64_t>(messy_rows().size()) + 2);
  std::string no_line_end = std::string(header) + good_row;
  no_line_end.pop_back();
  write("TreeManagerState_0.csv", no_line_end);
  const auto last = read_frame_file((folder_ / "TreeManagerState_0.csv").string());
  ASSERT_TRUE(last);
  EXPECT_EQ(last->size(), 1U);
  EXPECT_TRUE(last.issues.empty());
}

/// A text with the bytes behind it that scan_decimal may look at.
std::string with_margin(const std::string& text) { return text + std::string(scan_margin, '\0'); }

TEST(ScanDecimal, IsParseDecimalForPlainNumbersAndLeavesTheRest) {
  for (const char* text : {"0", "-0.5", "0.1", "12345.678901", "-12.000001", ".5", "5.", "123456789012345", "0.00000000000001"}) {
    const std::string padded = with_margin(text);
    const ScannedDecimal scanned = scan_decimal(padded.c_str());
    EXPECT_TRUE(scanned.clean) << text;
    EXPECT_EQ(*scanned.end, '\0') << text;
    EXPECT_EQ(scanned.value, parse_decimal(text)) << text;
  }
  for (const char* text : {"", "-", ".", "-.", "x", "1234567890123456", "0.0000000000000001", "True"})
    EXPECT_FALSE(scan_decimal(with_margin(text).c_str()).clean) << text;
  const std::string exponent = with_margin("1e5");
  EXPECT_EQ(*scan_decimal(exponent.c_str()).end, 'e') << "what follows is the caller's to judge";
}

TEST(ScanDecimal, IsParseDecimalForAnyNumberOfDecimalsWhateverFollows) {
  const std::string digits = "90817263540918";
  for (std::size_t before = 0; before <= 3; ++before) {
    for (std::size_t decimals = 0; decimals <= 12; ++decimals) {
      const std::string text = "-" + digits.substr(0, before) + "." + digits.substr(before, decimals);
      if (before + decimals == 0) continue;
      for (const char* behind : {",12345678", "\n", "\r\n9", "/9", ":0", "\xff", ".5"}) {
        const std::string row = with_margin(text + behind);
        const ScannedDecimal scanned = scan_decimal(row.c_str());
        EXPECT_TRUE(scanned.clean) << text;
        EXPECT_EQ(scanned.end - row.c_str(), static_cast<std::ptrdiff_t>(text.size())) << text << behind;
        EXPECT_EQ(scanned.value, parse_decimal(text)) << text;
      }
    }
  }
}

TEST(FindEither, IsTheFirstOfBothWhereverItStands) {
  for (std::size_t first = 0; first < 20; ++first) {
    for (std::size_t second = 0; second < 20; ++second) {
      std::string text(first + second + 2, 'x');
      text[first / 2] = '-';  // one less than a point, one more than a comma: no neighbours of what is looked for count
      text[first] = ',';
      text[first + second + 1] = '\n';
      const std::string padded = with_margin(text);
      EXPECT_EQ(find_either(padded.c_str(), ',', '\n') - padded.c_str(), static_cast<std::ptrdiff_t>(first));
      EXPECT_EQ(find_either(padded.c_str(), ';', '\n') - padded.c_str(), static_cast<std::ptrdiff_t>(first + second + 1));
    }
  }
}

TEST(ParseDecimal, AgreesWithStrtodAndRefusesWhatIsNoNumber) {
  for (const char* text : {"0", "-0.5", "1697617761.634079000", "0.1", "+3.25", " 7 ", "1e-3", "123456789012345678901234",
                           "0.30000000000000004", "-12.000001", ".5", "5."}) {
    ASSERT_TRUE(parse_decimal(text)) << text;
    EXPECT_EQ(*parse_decimal(text), std::strtod(text, nullptr)) << text;
  }
  for (const char* text : {"", " ", "-", ".", "nan", "inf", "1,5", "1.2.3", "0x10", "1 2", "--1", "+-1", "1e", "1e999"})
    EXPECT_FALSE(parse_decimal(text)) << text;
}

TEST(ReadRealFrames, ReadsAWholeSequenceWithoutAComplaint) {
  const char* set = std::getenv("STEMWISE_SHARED_DATA");
  const std::string data = set != nullptr ? set : STEMWISE_SOURCE_DIR "/../shared/data";
  if (!fs::exists(data + "/stein")) GTEST_SKIP() << "no data at " << data;
  const auto read = read_frame_folder(data + "/stein");
  ASSERT_TRUE(read);
  EXPECT_TRUE(read.issues.empty());
  EXPECT_EQ(read->frames->frames.size(), 1046U);
  EXPECT_EQ(read->frames->frames.size(), read_frame_folder(data + "/stein", 1)->frames->frames.size());
}

}  // namespace
}  // namespace stemwise
