// Every switch of the ablations changes what it names.
#include "tests/core/treeloc/synthetic_scene.hpp"
#include <gtest/gtest.h>

#include "core/treeloc/correct_vertical.hpp"
#include "core/treeloc/estimate_planar_pose.hpp"
#include "core/treeloc/estimate_roll_pitch.hpp"
#include "core/treeloc/evaluate.hpp"
#include "core/treeloc/overlap_score.hpp"
#include "core/treeloc/prepare_scene.hpp"
#include "core/treeloc/reject_outliers.hpp"
#include "core/treeloc/retrieve_scenes.hpp"
#include "core/treeloc/tree_distribution_histogram.hpp"

namespace stemwise::treeloc {
namespace {

using ::stemwise::testing::random_stand;
using ::stemwise::testing::walk;

Scene scene_of(const std::vector<Eigen::Vector3d>& places, double dbh_m = 0.3) {
  Scene scene;
  for (const auto& p : places) {
    SceneTree tree;
    tree.position_m = p;
    tree.axis = Eigen::Vector3d::UnitZ();
    tree.dbh_m = dbh_m;
    tree.has_height = tree.reconstructed = true;
    scene.trees.push_back(tree);
  }
  return scene;
}

TEST(Switch, TdhAndPdhDecideWhichScenesThePrefilterKeeps) {
  const PublishedDescriptor query{{4.0F, 0.0F}, {6.0F, 0.0F}, {}};
  const std::vector<PublishedDescriptor> database{{{4.0F, 0.0F}, {0.0F, 6.0F}, {}}, {{0.0F, 4.0F}, {6.0F, 0.0F}, {}}};
  RetrieveSettings one;
  one.kept_by_histograms = 1;
  EXPECT_EQ(retrieve_scenes(query, database, 2, true, false, one).at(0).scene, 0U) << "by TDH alone";
  EXPECT_EQ(retrieve_scenes(query, database, 2, false, true, one).at(0).scene, 1U) << "by PDH alone";
  EXPECT_EQ(retrieve_scenes(query, database, 2, false, false, one).size(), 2U) << "without either there is no prefilter";
  one.histograms = false;
  EXPECT_EQ(retrieve_scenes(query, database, 2, true, true, one).size(), 2U);
}

TEST(Switch, ThePenaltyLowersTheScoreOfFarCandidatesOnly) {
  OverlapScoreSettings off;
  off.penalty = false;
  EXPECT_EQ(overlap_score(10, 20, 20, 4.0, off), overlap_score(10, 20, 20, 0.0, {}));
  EXPECT_LT(overlap_score(10, 20, 20, 4.0, {}), 0.6 * overlap_score(10, 20, 20, 4.0, off));
}

TEST(Switch, TheDbhFilterDropsTrianglesOfOtherDiameters) {
  const Scene thin = scene_of({{0, 0, 0}, {5, 0, 0}, {1, 3, 0}}, 0.15), thick = scene_of({{0, 0, 0}, {5, 0, 0}, {1, 3, 0}}, 0.6);
  TriangleMaker maker({});
  const auto q = maker.make(thin), c = maker.make(thick);
  RejectOutliersSettings off;
  off.dbh_filter = false;
  EXPECT_TRUE(match_triangles(q, c, thin, thick, {}).empty());
  EXPECT_EQ(match_triangles(q, c, thin, thick, off).size(), q.size());
}

TEST(Switch, YawVotingDropsMatchesThatDisagreeWithTheRest) {
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 6; ++i) places.insert(places.end(), {{10.0 * i, 0, 0}, {10.0 * i + 5, 0, 0}, {10.0 * i + 1, 3, 0}});
  auto turned = places;
  for (std::size_t i = 15; i < 18; ++i) turned[i] = {50 - (places[i].y() - 0), places[i].x() - 50, 0};  // the last one by 90 degrees
  const Scene a = scene_of(places), b = scene_of(turned);
  std::vector<Triangle> triangles;
  std::vector<TriangleMatch> matches;
  for (std::uint8_t i = 0; i < 6; ++i) {
    Triangle t;
    for (std::uint8_t v = 0; v < 3; ++v) t.tree[v] = static_cast<std::uint8_t>(3 * i + v);
    triangles.push_back(t);
    matches.push_back({i, i});
  }
  RejectOutliersSettings off;
  off.yaw_voting = false;
  EXPECT_EQ(vote_yaw(matches, triangles, triangles, a, b, {}).size(), 5U);
  EXPECT_EQ(vote_yaw(matches, triangles, triangles, a, b, off).size(), 6U);
}

TEST(Switch, IrlsKeepsAWrongTriangleFromMovingThePose) {
  std::vector<Eigen::Vector3d> places, shifted;
  for (int i = 0; i < 6; ++i) places.insert(places.end(), {{8.0 * i, 0, 0}, {8.0 * i + 5, 0, 0}, {8.0 * i + 1, 3, 0}});
  for (std::size_t i = 0; i < places.size(); ++i) shifted.push_back(places[i] + Eigen::Vector3d(1.0, i < 3 ? 6.0 : 0.0, 0.0));
  const Scene a = scene_of(places), b = scene_of(shifted);
  std::vector<Triangle> triangles;
  std::vector<TriangleMatch> matches;
  for (std::uint8_t i = 0; i < 6; ++i) {
    Triangle t;
    for (std::uint8_t v = 0; v < 3; ++v) t.tree[v] = static_cast<std::uint8_t>(3 * i + v);
    triangles.push_back(t);
    matches.push_back({i, i});
  }
  const auto error_m = [&](const EstimatePlanarPoseSettings& settings) {
    const PlanarPose pose = estimate_planar_pose(matches, triangles, triangles, a, b, settings);
    return (pose * Eigen::Vector2d(40.0, 0.0) - Eigen::Vector2d(41.0, 0.0)).norm();
  };
  EstimatePlanarPoseSettings off;
  off.irls = false;
  EXPECT_LT(error_m({}), 0.5 * error_m(off));
}

TEST(Switch, JointVerticalCorrectionTurnsAndTheOtherOnlyLifts) {
  const std::vector<Eigen::Vector3d> flat{{0, 0, 0}, {9, 1, 0}, {-8, 3, 0}, {2, 9, 0}, {1, -9, 0}, {-6, -6, 0}, {7, 7, 0}};
  auto tilted = flat;
  for (auto& p : tilted) p.z() = 0.3 + 0.03 * p.x();
  const Scene a = scene_of(flat), b = scene_of(tilted);
  std::vector<TreePair> pairs;
  for (std::uint16_t i = 0; i < flat.size(); ++i) pairs.push_back({i, i, 0.0F});
  CorrectVerticalSettings off;
  off.joint = false;
  EXPECT_GT(std::abs(roll_pitch_yaw(correct_vertical(a, b, pairs, {}, {}, 1).rotation).pitch_rad), 0.02);
  EXPECT_EQ(correct_vertical(a, b, pairs, {}, off, 1).rotation, Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  EXPECT_GT(correct_vertical(a, b, pairs, {}, off, 1).translation_m.z(), 0.2);
}

TEST(Switch, RollAndPitchFromAxesCanBeLeftOut) {
  const std::vector<Eigen::Vector3d> places{{0, 0, 0}, {9, 1, 0}, {-8, 3, 0}, {2, 9, 0}, {1, -9, 0}, {-6, -6, 0}, {7, 7, 0}};
  const Scene a = scene_of(places);
  Scene b = a;
  for (SceneTree& tree : b.trees) tree.axis = rotation_from({0.05, 0.0, 0.0}) * tree.axis;
  std::vector<TreePair> pairs;
  for (std::uint16_t i = 0; i < places.size(); ++i) pairs.push_back({i, i, 0.0F});
  EstimateRollPitchSettings off;
  off.enabled = false;
  EXPECT_NEAR(roll_pitch_yaw(estimate_roll_pitch(a, b, pairs, {}, {})).roll_rad, 0.05, 1e-6);
  EXPECT_EQ(estimate_roll_pitch(a, b, pairs, {}, off), Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
}

TEST(Switch, PrecedingFramesLendTheirTreesUnlessSwitchedOff) {
  FrameSet set = walk(random_stand(60.0, 150, 1), 8.0, 40, 0.0, 2);
  set.frames[20].stems.resize(4);
  PrepareSettings settings;
  settings.min_reconstructed = 10;
  const auto borrowed = [&] {
    const Scene scene = prepare_frame_scene(set, 20, settings, {});
    return std::count_if(scene.trees.begin(), scene.trees.end(), [](const SceneTree& t) { return !t.own; });
  };
  EXPECT_GT(borrowed(), 5);
  settings.preceding_frames = 0;
  EXPECT_EQ(borrowed(), 0);
}

TEST(Switch, OverlappingHistogramBinsCountATreeOnceOrTwice) {
  const Scene scene = scene_of({{5.5, 0, 0}}, 0.12);  // in two widened bins of distance and two of diameter
  const auto total = [&](bool once) {
    TdhSettings settings;
    settings.count_once = once;
    double sum = 0.0;
    for (const float v : tree_distribution_histogram(scene, settings)) sum += v;
    return sum;
  };
  EXPECT_GT(total(false), 2.0 * total(true));
}

/// Evaluates a small world with one setting changed.
Evaluation evaluated(Method method, const std::string& key, const std::string& value) {
  Settings settings = settings_for(method, "route");
  if (method == Method::stemwise) settings = settings_for(method, "auto");
  const Issues wrong = key.empty() ? Issues{} : set_field(settings.fields(), key, value);
  EXPECT_TRUE(wrong.empty()) << key;
  const auto stand = random_stand(100.0, 350, 1);
  auto map = prepare_frame_scenes(walk(stand, 20.0, 40, 0.06, 2), settings.scene, settings.axes, 0);
  auto queries = prepare_frame_scenes(walk(stand, 21.5, 15, 0.06, 3, 0.2), settings.scene, settings.axes, 0);
  return evaluate_inter(std::move(queries), std::move(map), {}, settings, {}, 0, {});
}

/// Something in the rows: which candidate, its score, its pose.
double fingerprint(const Evaluation& e) {
  double sum = 0.0, weight = 1.0;
  for (const QueryRow& row : e.rows) {
    sum += weight * (static_cast<double>(row.candidate) + row.score + row.error.spatial_m() + row.error.rotation_deg() + row.votes);
    weight += 0.37;
  }
  return sum;
}

TEST(Switch, EveryAblationOfTheDefaultMethodReachesTheResult) {
  const double plain = fingerprint(evaluated(Method::stemwise, "", ""));
  const std::pair<const char*, const char*> switches[] = {
      {"triangles.orientation", "false"}, {"triangles.area", "true"},  {"vote.gate_m", "100"},         {"vote.tau_dbh_m", "0.01"},
      {"match.steps", "1"},               {"vote.verified", "1"},      {"verify.strong_share", "1"}, {"verify.propagate_most", "0"},
      {"axes.enabled", "false"},          {"refine.iterations", "1"},  {"refine.height_prior", "false"}, {"fuse.enabled", "false"},
      {"verify.penalty_m", "2"},          {"scene.local_radius_m", "12"}};
  for (const auto& [key, value] : switches) EXPECT_NE(fingerprint(evaluated(Method::stemwise, key, value)), plain) << key;
}

TEST(Switch, EveryAblationOfThePublishedMethodReachesTheResult) {
  const double plain = fingerprint(evaluated(Method::treelocpp, "", ""));
  const std::pair<const char*, const char*> switches[] = {{"retrieve.kept_by_histograms", "2"}, {"overlap.penalty", "false"},   {"overlap.sigma_t_m", "2"},
                                                          {"planar.irls", "false"},       {"roll_pitch.enabled", "false"}, {"vertical.joint", "false"},
                                                          {"axes.enabled", "false"},      {"retrieve.verified", "1"},      {"scene.local_radius_m", "12"}};
  for (const auto& [key, value] : switches) EXPECT_NE(fingerprint(evaluated(Method::treelocpp, key, value)), plain) << key;
}

}  // namespace
}  // namespace stemwise::treeloc
