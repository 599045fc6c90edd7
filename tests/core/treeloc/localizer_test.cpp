#include "core/treeloc/localizer.hpp"

#include "tests/core/treeloc/synthetic_scene.hpp"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/treeloc/evaluate.hpp"
#include "core/treeloc/prepare_scene.hpp"
#include "core/treeloc/triangle_index.hpp"

namespace stemwise::treeloc {
namespace {

using ::stemwise::testing::random_stand;
using ::stemwise::testing::walk;

std::vector<Scene> scenes_of(const FrameSet& set, const Settings& settings) {
  return prepare_frame_scenes(set, settings.scene, settings.axes, 0);
}

class LocalizerOfMethod : public ::testing::TestWithParam<Method> {};

TEST_P(LocalizerOfMethod, FindsTheTrueSceneAndPoseInAllSixDegreesOfFreedom) {
  const Settings settings = settings_for(GetParam(), "auto");
  const auto stand = random_stand(100.0, 450, 1);
  const auto localizer = make_localizer(settings);
  localizer->add(scenes_of(walk(stand, 20.0, 60, 0.02, 2), settings), 0);
  const auto queries = scenes_of(walk(stand, 20.5, 20, 0.02, 3, 0.1), settings);
  const auto all = localize_all(*localizer, queries, {}, 0, {});
  int good = 0;
  for (std::size_t q = 0; q < queries.size(); ++q) {
    ASSERT_FALSE(all[q].candidates.empty());
    const Candidate& best = all[q].candidates.front();
    const RigidTransform truth = localizer->scenes()[best.scene].survey_from_scene.inverse() * queries[q].survey_from_scene;
    const PoseError error = pose_error(best.candidate_from_query, truth);
    good += error.spatial_m() < 0.2 && error.rotation_deg() < 1.0 && truth.translation_m.norm() < 5.0 ? 1 : 0;
  }
  EXPECT_GE(good, 19);
}

INSTANTIATE_TEST_SUITE_P(Methods, LocalizerOfMethod, ::testing::Values(Method::stemwise, Method::treelocpp, Method::treeloc),
                         [](const auto& method) {
                           return method.param == Method::stemwise    ? "stemwise"
                                  : method.param == Method::treelocpp ? "published"
                                                                      : "predecessor";
                         });

TEST(Localizer, ASurveyAddedInPartsIsTheSameAsAtOnce) {
  const Settings settings = settings_for(Method::stemwise, "auto");
  const auto stand = random_stand(80.0, 300, 4);
  auto scenes = scenes_of(walk(stand, 15.0, 40, 0.03, 5), settings);
  const auto queries = scenes_of(walk(stand, 16.0, 10, 0.03, 6), settings);
  const auto whole = make_localizer(settings), parts = make_localizer(settings);
  parts->add(std::vector<Scene>{scenes.begin(), scenes.begin() + 15}, 1);
  parts->add(std::vector<Scene>{scenes.begin() + 15, scenes.end()}, 2);
  whole->add(std::move(scenes), 1);
  const auto a = localize_all(*whole, queries, {}, 1, {}), b = localize_all(*parts, queries, {}, 3, {});
  for (std::size_t q = 0; q < queries.size(); ++q) {
    EXPECT_EQ(a[q].candidates.front().scene, b[q].candidates.front().scene);
    EXPECT_EQ(a[q].candidates.front().pairs, b[q].candidates.front().pairs);
    EXPECT_LT(
        (a[q].candidates.front().candidate_from_query.translation_m - b[q].candidates.front().candidate_from_query.translation_m)
            .norm(),
        0.02);
  }
}

TEST(Localizer, ScenesThatCameDescribedAnswerAsThoseItDescribesItself) {
  for (const Method method : {Method::stemwise, Method::treelocpp}) {
    const Settings settings = settings_for(method, "auto");
    const auto stand = random_stand(80.0, 300, 4);
    const auto scenes = scenes_of(walk(stand, 15.0, 40, 0.03, 5), settings);
    const auto queries = scenes_of(walk(stand, 16.0, 10, 0.03, 6), settings);
    const auto plain = make_localizer(settings), described = make_localizer(settings);
    plain->add(scenes, 1);
    const auto part = [&](std::size_t first, std::size_t end) { return std::vector<Scene>(scenes.begin() + std::ptrdiff_t(first), scenes.begin() + std::ptrdiff_t(end)); };
    for (const auto& [first, end] : {std::pair{0U, 25U}, std::pair{25U, 40U}}) {  // the second one's scenes count on
      auto triangles = std::make_shared<IndexSegment>(index_scenes(part(first, end), settings.triangles, 2));
      described->add({part(first, end), std::move(triangles)}, 1);
    }
    const auto a = localize_all(*plain, queries, {}, 1, {}), b = localize_all(*described, queries, {}, 1, {});
    for (std::size_t q = 0; q < queries.size(); ++q) {
      EXPECT_EQ(a[q].candidates.front().scene, b[q].candidates.front().scene);
      EXPECT_EQ(a[q].candidates.front().score, b[q].candidates.front().score);
    }
  }
}

TEST(TriangleIndex, RefusesTrianglesOfOtherSettings) {
  TriangleSettings coarse;
  coarse.step_m = 0.5;
  TriangleIndex index{TriangleSettings{}};
  EXPECT_THROW(index.add(index_scenes({}, coarse, 1)), std::invalid_argument);
  index.add(index_scenes({}, {}, 1));
  EXPECT_EQ(index.triangle_count(), 0U);
}

TEST(Localizer, NeverLooksAtScenesBeyondTheLimit) {
  for (const Method method : {Method::stemwise, Method::treelocpp}) {
    const Settings settings = settings_for(method, "auto");
    const auto stand = random_stand(80.0, 300, 4);
    const auto scenes = scenes_of(walk(stand, 15.0, 40, 0.03, 5), settings);
    const auto localizer = make_localizer(settings);
    localizer->add(scenes, 0);
    const auto worker = localizer->worker();
    for (const std::uint32_t limit : {0U, 1U, 10U}) {
      for (const Candidate& c : worker->localize(scenes[20], limit).candidates) EXPECT_LT(c.scene, limit);
    }
  }
}

TEST(Localizer, AnEmptyOrTinySceneHasNoAnswerAndDoesNotCrash) {
  for (const Method method : {Method::stemwise, Method::treelocpp}) {
    const Settings settings = settings_for(method, "auto");
    const auto localizer = make_localizer(settings);
    localizer->add(scenes_of(walk(random_stand(80.0, 300, 4), 15.0, 10, 0.03, 5), settings), 0);
    const auto worker = localizer->worker();
    EXPECT_TRUE(worker->localize(Scene{}, QueryWorker::all_scenes).candidates.empty());
    Scene two;
    two.trees.resize(2);
    two.trees[1].position_m.x() = 3.0;
    EXPECT_TRUE(worker->localize(two, QueryWorker::all_scenes).candidates.empty());
  }
}

TEST(Metrics, FollowTheirDefinitions) {
  std::vector<QueryRow> rows(4);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].candidate = 1;
    rows[i].positive = i != 2;
    rows[i].score = 0.8 - 0.2 * static_cast<double>(i);  // 0.8 +, 0.6 +, 0.4 -, 0.2 +
  }
  const RetrievalMetrics m = retrieval_metrics(rows, 1000);
  EXPECT_DOUBLE_EQ(m.recall_at_1, 0.75);
  EXPECT_NEAR(m.mr, 2.0 / 3.0, 1e-9);
  EXPECT_NEAR(m.mf1, 6.0 / 7.0, 1e-9);
  EXPECT_GT(m.auc, 0.9);
  EXPECT_LT(m.auc, 1.0);
  EXPECT_EQ(retrieval_metrics({}, 1000).recall_at_1, 0.0);
}

TEST(Settings, RefuseNonsenseAndNameIt) {
  Settings settings = settings_for(Method::stemwise, "auto");
  EXPECT_TRUE(settings.check().empty());
  EXPECT_TRUE(set_field(settings.fields(), "triangles.step_m", "0").empty());
  ASSERT_EQ(settings.check().size(), 1U);
  EXPECT_EQ(settings.check()[0].column, "triangles.step_m");
  EXPECT_FALSE(set_field(settings.fields(), "triangles.stepm", "1").empty());
}

}  // namespace
}  // namespace stemwise::treeloc
