#include "core/geodesy/solve_gnss_track.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.hpp"

namespace stemwise {
namespace {

const Georeference truth{GeoreferenceKind::anchor, {48.77, 9.17, 410.0}, {0, 0, 0}, 212.5, 0, 0.0, ""};

/// A loop of 300 s at ten poses a second, up and down by 4 m.
std::vector<TrackPoint> walk() {
  std::vector<TrackPoint> track;
  for (int i = 0; i <= 3000; ++i) {
    const double t = 0.1 * i;
    track.push_back({1000.0 + t, {60.0 * std::sin(t / 40.0), 35.0 * std::cos(t / 55.0) + 0.1 * t, 2.0 * std::sin(t / 30.0)}});
  }
  return track;
}

Eigen::Vector3d place_at(double time_s) {
  const double t = time_s - 1000.0;
  return {60.0 * std::sin(t / 40.0), 35.0 * std::cos(t / 55.0) + 0.1 * t, 2.0 * std::sin(t / 30.0)};
}

/// A fix a second with `noise_m`; from `bad_from` to `bad_to` seconds 12 m to the side, as multipath does for minutes.
std::vector<GnssFix> fixes_of(double noise_m, double bad_from, double bad_to, std::uint64_t seed) {
  Random random(seed);
  std::vector<GnssFix> fixes;
  for (int i = 0; i < 300; ++i) {
    const double t = 1000.05 + i;
    Eigen::Vector3d p = place_at(t) + Eigen::Vector3d(random.normal(0, noise_m), random.normal(0, noise_m), random.normal(0, 2 * noise_m));
    if (i >= bad_from && i < bad_to) p += Eigen::Vector3d(9.0, -8.0, 15.0);
    fixes.push_back({t, geodetic_from_reference(truth, p), true, std::nullopt});
  }
  return fixes;
}

double planar_error_m(const Georeference& found, const Eigen::Vector3d& point) {
  return (reference_from_geodetic(truth, geodetic_from_reference(found, point)) - point).head<2>().norm();
}

TEST(SolveGnssTrack, ExactFixesGiveTheExactPlaceOfEveryTree) {
  const auto solved = solve_gnss_track(walk(), fixes_of(0.0, 0, 0, 1));
  ASSERT_TRUE(solved);
  EXPECT_EQ(solved->used, 300);
  for (const Eigen::Vector3d& point : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(80, -40, 3)})
    EXPECT_LT((reference_from_geodetic(truth, geodetic_from_reference(solved->georeference, point)) - point).norm(), 0.01);
}

TEST(SolveGnssTrack, MultipathOfATwoFifthsOfTheTrackIsLeftOutAndItsStretchesAreNamed) {
  const auto solved = solve_gnss_track(walk(), fixes_of(1.0, 90, 210, 2));
  ASSERT_TRUE(solved);
  EXPECT_LT(planar_error_m(solved->georeference, {0, 20, 0}), 0.5);
  EXPECT_LE(solved->used, 184);
  EXPECT_GE(solved->used, 170);
  ASSERT_EQ(solved->georeference.residuals.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(solved->georeference.residuals[i].used, i < 3 || i > 6) << i;
  EXPECT_EQ(solved.issues.size(), 4u);
}

TEST(SolveGnssTrack, ItsUncertaintyCoversTheErrorMadeAlsoWhenErrorsLast) {
  int covered = 0;
  constexpr int runs = 60;
  for (int run = 0; run < runs; ++run) {
    Random random(100 + static_cast<std::uint64_t>(run));
    std::vector<GnssFix> fixes = fixes_of(0.2, 0, 0, 200 + static_cast<std::uint64_t>(run));
    Eigen::Vector3d drift = Eigen::Vector3d(random.normal(0, 1.0), random.normal(0, 1.0), 0);
    for (GnssFix& fix : fixes) {  // a first-order process of 10 s and 1 m
      drift = drift * std::exp(-1.0 / 10.0) + std::sqrt(1.0 - std::exp(-2.0 / 10.0)) * Eigen::Vector3d(random.normal(0, 1.0), random.normal(0, 1.0), 0.0);
      fix.on_earth = geodetic_from_reference(truth, reference_from_geodetic(truth, fix.on_earth) + drift);
    }
    const auto solved = solve_gnss_track(walk(), fixes);
    ASSERT_TRUE(solved);
    const double error_m = planar_error_m(solved->georeference, solved->georeference.anchored_point_m);
    if (error_m < 2.45 * solved->georeference.sd_m) ++covered;  // 95 % of a Rayleigh distribution
  }
  EXPECT_GE(covered, 50);
}

TEST(SolveGnssTrack, ClocksThatDoNotMeetAreRefusedWithBothSpans) {
  std::vector<GnssFix> late = fixes_of(0.0, 0, 0, 1);
  for (GnssFix& fix : late) fix.timestamp_s += 1e6;
  const auto refused = solve_gnss_track(walk(), late);
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.issues.front()).find("1000.000 to 1300.000"), std::string::npos);
  GnssSettings settings;
  settings.time_offset_s = -1e6;
  EXPECT_TRUE(solve_gnss_track(walk(), late, settings));
}

TEST(SolveGnssTrack, AReceiverThatStoodStillIsRefused) {
  std::vector<TrackPoint> still = walk();
  for (TrackPoint& point : still) point.in_reference_m = {1, 2, 3};
  const auto refused = solve_gnss_track(still, fixes_of(1.0, 0, 0, 3));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.issues.front().text.find("less than 5 m"), std::string::npos);
}

}  // namespace
}  // namespace stemwise
