#include "core/survey/build_global_inventory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
#include "core/survey/move_frames.hpp"
#include "core/survey/simulate_frames.hpp"

namespace stemwise {
namespace {

/// A stand with at least 1 m between stems on a slope.
std::vector<Stem> stand(int n, double side_m, std::uint64_t seed, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) {
  Random random(seed);
  std::vector<Stem> stems;
  while (static_cast<int>(stems.size()) < n) {
    Stem s;
    s.x_m = origin.x() + random.uniform(0, side_m);
    s.y_m = origin.y() + random.uniform(0, side_m);
    const bool crowded = std::any_of(stems.begin(), stems.end(), [&](const Stem& o) { return std::hypot(o.x_m - s.x_m, o.y_m - s.y_m) < 1.0; });
    if (crowded) continue;
    s.z_m = origin.z() + 0.1 * (s.x_m - origin.x()) + random.normal(0, 0.2);
    s.dbh_m = random.uniform(0.1, 0.6);
    s.axis = Eigen::Vector3d(random.normal(0, 0.05), random.normal(0, 0.05), 1.0).normalized();
    stems.push_back(s);
  }
  return stems;
}

FrameSet walk(const std::vector<Stem>& stems, std::uint64_t seed = 1) {
  SimulateFramesSettings settings;
  settings.seed = seed;
  return simulate_frames(stems, walk_over(stems, settings), settings);
}

const Stem* nearest(const std::vector<Stem>& stems, const Stem& to) {
  return &*std::min_element(stems.begin(), stems.end(), [&](const Stem& a, const Stem& b) {
    return std::hypot(a.x_m - to.x_m, a.y_m - to.y_m) < std::hypot(b.x_m - to.x_m, b.y_m - to.y_m);
  });
}

struct Comparison {
  int found = 0, extra = 0;
  double worst_position_m = 0.0, mean_position_m = 0.0, mean_dbh_m = 0.0;
};

Comparison compare(const std::vector<Stem>& truth, const std::vector<Stem>& stems) {
  Comparison c;
  for (const Stem& t : truth) {
    const Stem* s = nearest(stems, t);
    const double d = std::hypot(s->x_m - t.x_m, s->y_m - t.y_m);
    if (d > 0.3) continue;
    ++c.found;
    c.worst_position_m = std::max(c.worst_position_m, d);
    c.mean_position_m += d;
    if (s->dbh_m) c.mean_dbh_m += std::abs(*s->dbh_m - *t.dbh_m);
  }
  c.mean_position_m /= c.found;
  c.mean_dbh_m /= c.found;
  for (const Stem& s : stems) {
    const Stem* t = nearest(truth, s);
    c.extra += std::hypot(s.x_m - t->x_m, s.y_m - t->y_m) > 0.3 ? 1 : 0;
  }
  return c;
}

TEST(BuildGlobalInventory, EveryTreeSeenFromManyFramesBecomesOneStemNearTheTruth) {
  const std::vector<Stem> truth = stand(300, 60, 1);
  const GlobalInventory global = build_global_inventory(walk(truth));
  const Comparison c = compare(truth, global.stems);
  EXPECT_GE(c.found, 297);
  EXPECT_LE(c.extra, 3);
  EXPECT_LT(c.mean_position_m, 0.04);
  EXPECT_LT(c.mean_dbh_m, 0.02);
  EXPECT_EQ(global.report.stems, static_cast<int>(global.stems.size()));
  EXPECT_TRUE(global.report.down_weighted.empty());
}

TEST(BuildGlobalInventory, TheSameFramesGiveTheSameListToTheLastBit) {
  const FrameSet frames = walk(stand(100, 40, 2));
  const GlobalInventory a = build_global_inventory(frames), b = build_global_inventory(frames);
  EXPECT_EQ(a.stems, b.stems);
  EXPECT_EQ(a.sightings, b.sightings);
  EXPECT_EQ(a.stems.front().source_id, "g1");
}

TEST(BuildGlobalInventory, MovingAndTiltingTheSurveyMovesTheList) {
  const FrameSet frames = walk(stand(200, 50, 3));
  const RigidTransform moved_from_survey{rotation_from({radians(10), radians(-10), 2.2}), {500, -300, 40}};
  const std::vector<Stem> here = build_global_inventory(frames).stems;
  const std::vector<Stem> there = build_global_inventory(move_frames(frames, moved_from_survey)).stems;
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    const Eigen::Vector3d expected = moved_from_survey * Eigen::Vector3d(here[i].x_m, here[i].y_m, *here[i].z_m);
    EXPECT_LT((Eigen::Vector3d(there[i].x_m, there[i].y_m, *there[i].z_m) - expected).norm(), 0.05) << i;
    EXPECT_EQ(here[i].dbh_m, there[i].dbh_m);
    EXPECT_EQ(here[i].times_seen, there[i].times_seen);
  }
}

TEST(BuildGlobalInventory, LosesNothingAtUtmScale) {
  const Eigen::Vector3d utm(512345.0, 5412345.0, 800.0);
  const std::vector<Stem> truth = stand(150, 45, 4, utm);
  const Comparison c = compare(truth, build_global_inventory(walk(truth)).stems);
  EXPECT_GE(c.found, 148);
  EXPECT_LT(c.mean_position_m, 0.04);
}

TEST(BuildGlobalInventory, AFrameThatIsDisplacedIsListedAndMovesNoTree) {
  const std::vector<Stem> truth = stand(300, 60, 5);
  FrameSet frames = walk(truth);
  for (const std::size_t f : {std::size_t{10}, std::size_t{11}, std::size_t{40}}) frames.frames[f].pose.survey_from_frame.translation_m += Eigen::Vector3d(2.0, -1.0, 0.0);
  const GlobalInventory global = build_global_inventory(frames);
  ASSERT_EQ(global.report.down_weighted.size(), 3u);
  EXPECT_EQ(global.report.down_weighted[0].number, 10);
  EXPECT_EQ(global.report.down_weighted[2].number, 40);
  EXPECT_NEAR(global.report.down_weighted[0].displacement_m, std::hypot(2.0, 1.0), 0.1);
  const Comparison c = compare(truth, global.stems);
  EXPECT_GE(c.found, 297);
  EXPECT_LE(c.extra, 4);
}

TEST(BuildGlobalInventory, OneFrameWithBaseHeightsOffByMetresDoesNotRaiseTheGround) {
  const std::vector<Stem> truth = stand(200, 50, 6);
  FrameSet frames = walk(truth);
  for (std::size_t f = 0; f < frames.frames.size(); f += 6)
    for (Stem& s : frames.frames[f].stems) *s.z_m += 3.0;
  const std::vector<Stem> stems = build_global_inventory(frames).stems;
  std::vector<double> off;
  for (const Stem& s : stems) off.push_back(std::abs(*s.z_m - *nearest(truth, s)->z_m));
  std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2), off.end());
  EXPECT_LT(off[off.size() / 2], 0.35);
}

TEST(BuildGlobalInventory, OnlyMeasuredDbhBecomesDbh) {
  const std::vector<Stem> truth = stand(60, 30, 7);
  FrameSet frames = walk(truth);
  for (Frame& frame : frames.frames)
    for (Stem& s : frame.stems) s.dbh_m.reset();
  for (const Stem& s : build_global_inventory(frames).stems) {
    EXPECT_FALSE(s.dbh_m.has_value());
    EXPECT_TRUE(s.dbh_approximation_m.has_value());
  }
}

TEST(BuildGlobalInventory, NoisyPositionsDoNotMakeTwoStemsOfOne) {
  std::vector<Stem> truth;
  for (const Stem& stem : stand(150, 60, 12))
    if (truth.empty() || std::hypot(nearest(truth, stem)->x_m - stem.x_m, nearest(truth, stem)->y_m - stem.y_m) > 1.5) truth.push_back(stem);
  SimulateFramesSettings settings;
  settings.position_noise_m = 0.15;
  settings.seed = 3;
  const auto stems = build_global_inventory(simulate_frames(truth, walk_over(truth, settings), settings)).stems;
  EXPECT_LE(stems.size(), truth.size() + truth.size() / 4);
  EXPECT_GE(compare(truth, stems).found, static_cast<int>(0.95 * static_cast<double>(truth.size())));
}

TEST(BuildGlobalInventory, NoFramesGiveNoStems) {
  EXPECT_TRUE(build_global_inventory(FrameSet{}).stems.empty());
  EXPECT_TRUE(build_global_inventory(FrameSet{{Frame{}}}).stems.empty());
}

TEST(BuildGlobalInventory, SightingsNameFramesAndCountAsTimesSeen) {
  const FrameSet frames = walk(stand(50, 30, 8));
  const GlobalInventory global = build_global_inventory(frames);
  ASSERT_EQ(global.sightings.size(), global.stems.size());
  for (std::size_t i = 0; i < global.stems.size(); ++i) {
    EXPECT_EQ(static_cast<int>(global.sightings[i].size()), global.stems[i].times_seen);
    for (std::size_t k = 1; k < global.sightings[i].size(); ++k)
      EXPECT_LT(global.sightings[i][k - 1].frame_number, global.sightings[i][k].frame_number);
  }
}

TEST(BuildGlobalInventory, CancelStopsIt) {
  const std::atomic<bool> cancel{true};
  EXPECT_THROW(build_global_inventory(FrameSet{}, {}, Progress({}, &cancel)), Cancelled);
}

}  // namespace
}  // namespace stemwise
