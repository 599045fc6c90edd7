#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/app/run_program.hpp"

namespace stemwise::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

/// Two simulated surveys by frames in one frame, made once.
class EvaluateCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<Folder>();
    const ProgramRun run = run_stemwise({"simulate", "-o", *folder_ / "sim", "--years", "2015,2019", "--stems", "500", "--frames", "--yaw-deg", "0", "--shift-m", "0",
                                         "--tilt-deg", "0", "--seed", "3", "--quiet"});
    ASSERT_EQ(run.code, 0) << run.err;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string year(const std::string& name) { return *folder_ / ("sim/" + name); }
  static std::string out(const std::string& name) { return *folder_ / name; }
  static Json json_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "evaluate");
    arguments.insert(arguments.end(), {"--quiet", "--json", "-"});
    const ProgramRun run = run_stemwise(arguments);
    EXPECT_EQ(run.code, 0) << run.err;
    return Json::parse(run.out, nullptr, false);
  }

  static std::unique_ptr<Folder> folder_;
};
std::unique_ptr<Folder> EvaluateCommand::folder_;

TEST_F(EvaluateCommand, WritesTheRowsOfTheContractAndPlots) {
  const Json json = json_of({"inter", year("2015"), year("2019"), "--csv", out("a.csv"), "--plots", out("plots")});
  EXPECT_GE(json["recall_at_1"], 0.95);
  EXPECT_EQ(json["acceptance"]["accepted_wrong_by_more_than_1_m"], 0);
  EXPECT_GE(json["calibration"]["inside_95"], 0.8);
  EXPECT_GT(json["calibration"]["poses"], 50);
  EXPECT_THAT(text_of(out("a.csv")), StartsWith("query,candidate,positive,score,dx_m,dy_m,dz_m,droll_deg,dpitch_deg,dyaw_deg"));
  for (const char* name : {"precision_recall", "position_error", "rotation_error", "query_time"}) {
    EXPECT_THAT(text_of(out(std::string("plots/") + name + ".png")), HasSubstr("PNG")) << name;
    EXPECT_THAT(text_of(out(std::string("plots/") + name + ".svg")), HasSubstr("<svg")) << name;
  }
}

TEST_F(EvaluateCommand, LocalisesInAGlobalListToo) {
  const Json json = json_of({"inter", year("2015"), year("2019"), "--map-mode", "global"});
  EXPECT_EQ(json["map_mode"], "global");
  EXPECT_GE(json["recall_at_1"], 0.9);
  const Json frames = json_of({"inter", year("2015"), year("2019")});
  EXPECT_NE(json["map_scenes"], frames["map_scenes"]);
}

TEST_F(EvaluateCommand, PairsTakesEveryDirectedPairWithMeansStabilityAndThresholds) {
  const Json json = json_of({"pairs", year("2015"), year("2019"), "--csv", out("pairs.csv")});
  ASSERT_EQ(json["pairs"].size(), 2U);
  EXPECT_EQ(json["pairs"][0]["query"], "2019");
  EXPECT_EQ(json["pairs"][0]["map"], "2015");
  EXPECT_EQ(json["pairs"][1]["map"], "2019");
  const double mean = 0.5 * (json["pairs"][0]["recall_at_1"].get<double>() + json["pairs"][1]["recall_at_1"].get<double>());
  EXPECT_NEAR(json["means"]["recall_at_1"]["mean"], mean, 1e-12);
  EXPECT_TRUE(json["means"]["auc"].contains("stability"));
  EXPECT_EQ(json["threshold_transfer"]["chosen_by_best_f1"].size(), 2U);
  EXPECT_EQ(json["threshold_transfer"]["fixed"]["pairs"].size(), 2U);
  EXPECT_THAT(text_of(out("pairs.csv")), HasSubstr("2015,2019,"));
  EXPECT_EQ(run_stemwise({"evaluate", "pairs", year("2015")}).code, 2);
}

TEST_F(EvaluateCommand, CompareReadsWhatTheOthersWroteAndIsTheSameForTheSameSeed) {
  ASSERT_EQ(json_of({"inter", year("2015"), year("2019"), "--csv", out("ours.csv")})["mode"], "inter");
  ASSERT_EQ(json_of({"inter", year("2015"), year("2019"), "--method", "treeloc++", "--csv", out("published.csv")})["mode"], "inter");
  const std::vector<std::string> call{"compare", out("ours.csv"), out("published.csv"), "--resamples", "200"};
  const Json json = json_of(call);
  EXPECT_GT(json["mcnemar"]["recall_at_1"]["only_a"], json["mcnemar"]["recall_at_1"]["only_b"]);
  EXPECT_LT(json["mcnemar"]["recall_at_1"]["p"], 0.01);
  EXPECT_GT(json["bootstrap"]["recall_at_1"]["ci95"][0], 0.0);
  EXPECT_EQ(json_of(call), json);
  auto other = call;
  other.insert(other.end(), {"--seed", "5"});
  EXPECT_NE(json_of(other)["bootstrap"], json["bootstrap"]);
}

TEST_F(EvaluateCommand, CompareNamesWhatIsWrongWithAFile) {
  const std::string bad = folder_->file("bad.csv", "query,score\n1,2\n");
  const std::string some = folder_->file("some.csv", "query,candidate,positive,score,dx_m,dy_m,dz_m,droll_deg,dpitch_deg,dyaw_deg\n1,2,1,0.5,0,0,0,0,0,0\n2,x,1,0.5,0,0,0,0,0,0\n3,,0,0,,,,,,\n");
  const ProgramRun run = run_stemwise({"evaluate", "compare", bad, some});
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("bad.csv"));
  EXPECT_THAT(run.err, HasSubstr("candidate"));
  const ProgramRun half = run_stemwise({"evaluate", "compare", some, some, "--json", "-", "--quiet"});
  EXPECT_EQ(half.code, 0) << half.err;
  EXPECT_EQ(Json::parse(half.out)["queries"], 2);
}

TEST_F(EvaluateCommand, SweepMakesItsTablesAndTheSameOnesForTheSameSeed) {
  const std::vector<std::string> call{"sweep", year("2015"), year("2019"), "--what", "deletion", "--trials", "1", "--threads", "1", "-o", out("deletion.csv")};
  const Json json = json_of(call);
  ASSERT_EQ(json["rows"].size(), 6U);
  EXPECT_EQ(json["rows"][0]["case"], "0 % of the trees deleted");
  EXPECT_LT(json["rows"][5]["recall_at_1"], json["rows"][0]["recall_at_1"]) << "half of the trees are gone";
  const std::string table = text_of(out("deletion.csv"));
  EXPECT_THAT(table, StartsWith("what,case,trials,queries,recall_at_1"));
  auto again = call;
  again[8] = "2";
  json_of(again);
  EXPECT_EQ(text_of(out("deletion.csv")), table) << "with two threads";
  const Json markdown = json_of({"sweep", year("2015"), year("2019"), "--what", "sigma_t", "-o", out("sigma.md")});
  EXPECT_THAT(text_of(out("sigma.md")), StartsWith("| what | case |"));
  EXPECT_EQ(run_stemwise({"evaluate", "sweep", year("2015"), "--what", "everything"}).code, 2);
  EXPECT_EQ(run_stemwise({"evaluate", "sweep", year("2015"), "-o", out("table.pdf")}).code, 2);
}

TEST_F(EvaluateCommand, AblationsHaveARowPerSwitchOfTheMethod) {
  const Json json = json_of({"sweep", year("2015"), year("2019"), "--what", "ablations", "--method", "treeloc++"});
  std::set<std::string> cases;
  for (const Json& row : json["rows"]) cases.insert(row["case"]);
  for (const char* name : {"all", "without TDH", "without PDH", "without spatial penalty", "without yaw voting", "without DBH filter", "without preceding frames",
                           "without IRLS", "without joint vertical correction"})
    EXPECT_TRUE(cases.contains(name)) << name;
}

TEST_F(EvaluateCommand, ASwitchThatTheMethodDoesNotHaveIsSaidAndOneOfThePresetHolds) {
  const ProgramRun run = run_stemwise({"evaluate", "inter", year("2015"), year("2019"), "--set", "tdh.enabled=false"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("tdh.enabled changes nothing"));
  const Json plain = json_of({"inter", year("2015"), year("2019"), "--method", "treeloc++"});
  const Json few = json_of({"inter", year("2015"), year("2019"), "--method", "treeloc++", "--set", "triangles.neighbours=4"});
  EXPECT_NE(plain["recall_at_1"], few["recall_at_1"]);
}

TEST_F(EvaluateCommand, TheCacheChangesNothingButTheTimes) {
  const std::string cache = out("cache");
  std::set<std::string> rows, results;
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--no-cache"}, {"--cache", cache}, {"--cache", cache}, {"--cache", "/dev/null/none"}}) {
    std::vector<std::string> call{"inter", year("2015"), year("2019"), "--csv", out("cached.csv")};
    call.insert(call.end(), more.begin(), more.end());
    Json json = json_of(call);
    EXPECT_TRUE(json["timing"].contains("map_from_cache"));
    json.erase("timing");
    results.insert(json.dump());
    rows.insert(text_of(out("cached.csv")));
  }
  EXPECT_EQ(rows.size(), 1U);
  EXPECT_EQ(results.size(), 1U);
}

/// Fast enough for every run; skipped where the data are not.
TEST(EvaluateRealData, SteinIsLocalisedAsTheAcceptanceTableAsks) {
  const char* shared = std::getenv("STEMWISE_SHARED_DATA");
  if (shared == nullptr || !fs::exists(fs::path(shared) / "stein")) GTEST_SKIP() << "STEMWISE_SHARED_DATA is not set: no real data";
  const ProgramRun run = run_stemwise({"evaluate", "intra", (fs::path(shared) / "stein").string(), "--quiet", "--json", "-"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_GE(json["recall_at_1"], 0.998);
  EXPECT_GE(json["mr"], 0.995);
  EXPECT_GE(json["auc"], 0.998);
  EXPECT_GE(json["pose_3d"]["r50"], 0.98);
  EXPECT_LE(json["pose_3d"]["ate_m"], 0.075);
  EXPECT_LE(json["pose_3d"]["are_deg"], 0.28);
  EXPECT_EQ(json["acceptance"]["accepted_wrong_by_more_than_1_m"], 0);
  EXPECT_GE(json["calibration"]["inside_95"], 0.9);
}

TEST(EvaluateRealData, SteinComesFromTheCacheTheSecondTime) {
  const char* shared = std::getenv("STEMWISE_SHARED_DATA");
  if (shared == nullptr || !fs::exists(fs::path(shared) / "stein")) GTEST_SKIP() << "STEMWISE_SHARED_DATA is not set: no real data";
  const Folder folder;
  for (const bool again : {false, true}) {
    const ProgramRun run = run_stemwise({"evaluate", "intra", (fs::path(shared) / "stein").string(), "--quiet", "--json", "-"}, "XDG_CACHE_HOME=" + folder.path().string());
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(Json::parse(run.out)["timing"]["map_from_cache"], again);
  }
  EXPECT_TRUE(fs::exists(folder.path() / "stemwise"));
}

}  // namespace
}  // namespace stemwise::testing
