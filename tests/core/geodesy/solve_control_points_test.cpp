#include "core/geodesy/solve_control_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stemwise {
namespace {

const Georeference truth{GeoreferenceKind::anchor, {48.77, 9.17, 410.0}, {0, 0, 0}, 212.5, 0, 0.0, ""};

std::vector<ControlPoint> exact_points(int count, const Eigen::Vector3d& offset_m = {0, 0, 0}) {
  std::vector<ControlPoint> points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p(40.0 * i, 25.0 * (i * i % 3), 2.0 * i);
    points.push_back({"row " + std::to_string(i + 2), p + offset_m, true, geodetic_from_reference(truth, p), true});
  }
  return points;
}

TEST(SolveControlPoints, FindsThePoseFromTwoPoints) {
  const auto solved = solve_control_points(exact_points(2), {});
  ASSERT_TRUE(solved);
  EXPECT_NEAR(solved->georeference.azimuth_deg, 212.5, 1e-3);
  const Geodetic back = geodetic_from_reference(solved->georeference, {100, 50, 1});
  EXPECT_LT((reference_from_geodetic(truth, back) - Eigen::Vector3d(100, 50, 1)).norm(), 0.01);
}

TEST(SolveControlPoints, LeavesOutAPointThatContradictsTheOthersAndNamesIt) {
  auto points = exact_points(6);
  points[3].in_reference_m.x() += 17.0;
  const auto solved = solve_control_points(points, {});
  ASSERT_TRUE(solved);
  EXPECT_FALSE(solved->georeference.residuals[3].used);
  EXPECT_EQ(solved->georeference.residuals[3].name, "row 5");
  EXPECT_NEAR(*solved->georeference.residuals[3].leave_one_out_m, 17.0, 0.05);
  EXPECT_LT(solved->rms_m, 0.01);
}

TEST(SolveControlPoints, RefusesWhenNoMajorityAgrees) {
  auto mixed_up = exact_points(5);
  mixed_up[0].in_reference_m.x() += 30.0;
  mixed_up[2].in_reference_m.y() += 45.0;
  mixed_up[4].in_reference_m.x() -= 60.0;
  const auto solved = solve_control_points(mixed_up, {});
  ASSERT_FALSE(solved);
  EXPECT_NE(solved.issues.front().text.find("of 5 control points agree"), std::string::npos) << solved.issues.front().text;
}

TEST(SolveControlPoints, LosesNothingWhenTheFrameHasUtmSizedCoordinates) {
  const Eigen::Vector3d offset(512'000.0, 5'402'000.0, 0.0);
  const auto solved = solve_control_points(exact_points(5, offset), {});
  ASSERT_TRUE(solved);
  const Geodetic back = geodetic_from_reference(solved->georeference, Eigen::Vector3d(100, 50, 1) + offset);
  EXPECT_LT((reference_from_geodetic(truth, back) - Eigen::Vector3d(100, 50, 1)).norm(), 0.01);
}

TEST(SolveControlPoints, KeepsAGivenAzimuthForASinglePoint) {
  ControlSettings settings;
  settings.translation_only = true;
  settings.azimuth_deg = 212.5;
  const auto solved = solve_control_points(exact_points(1), settings);
  ASSERT_TRUE(solved);
  EXPECT_NEAR(solved->georeference.azimuth_deg, 212.5, 1e-9);
}

/// Control points of a frame that leans by 3 and 2 degrees.
std::vector<ControlPoint> leaning_points() {
  Georeference leaning = truth;
  leaning.roll_deg = 3.0;
  leaning.pitch_deg = -2.0;
  std::vector<ControlPoint> points;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(40, 5, 2), Eigen::Vector3d(10, 50, 0), Eigen::Vector3d(60, 45, 4), Eigen::Vector3d(-20, 30, 1)})
    points.push_back({"p", p, true, geodetic_from_reference(leaning, p), true});
  return points;
}

TEST(SolveControlPoints, FindsTheLeanOfAFrameFromHeightsAndKeepsItLevelOnRequest) {
  const auto solved = solve_control_points(leaning_points(), {});
  ASSERT_TRUE(solved);
  EXPECT_TRUE(solved->tilted);
  EXPECT_NEAR(solved->georeference.roll_deg, 3.0, 0.01);
  EXPECT_NEAR(solved->georeference.pitch_deg, -2.0, 0.01);
  EXPECT_LT(solved->rms_m, 0.01);
  ControlSettings level;
  level.level = LevelChoice::level;
  const auto kept = solve_control_points(leaning_points(), level);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->georeference.roll_deg, 0.0);
  EXPECT_GT(*kept->height_rms_m, 0.5);
}

TEST(SolveControlPoints, NoiseInTheHeightsIsNoLean) {
  auto points = exact_points(6);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].on_earth.height_m += i % 2 == 0 ? 1.5 : -1.5;
  const auto solved = solve_control_points(points, {});
  ASSERT_TRUE(solved);
  EXPECT_FALSE(solved->tilted);
}

TEST(SolveControlPoints, ALeanFromPointsOnOneLineIsRefused) {
  auto points = exact_points(4);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].in_reference_m = {30.0 * static_cast<double>(i), 10.0 * static_cast<double>(i), 1.0};
    points[i].on_earth = geodetic_from_reference(truth, points[i].in_reference_m);
  }
  ControlSettings tilted;
  tilted.level = LevelChoice::tilted;
  EXPECT_FALSE(solve_control_points(points, tilted));
  EXPECT_TRUE(solve_control_points(points, {}));
}

TEST(SolveControlPoints, TheUncertaintyOfATreeGrowsWithItsDistanceFromThePoints) {
  auto points = exact_points(6);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].in_reference_m.x() += i % 2 == 0 ? 0.3 : -0.3;
  const auto solved = solve_control_points(points, {});
  ASSERT_TRUE(solved);
  const Georeference& g = solved->georeference;
  EXPECT_GT(g.sd_m, 0.05);
  const double near_m = position_sd_on_earth_m(g, g.anchored_point_m, 0.1);
  EXPECT_DOUBLE_EQ(near_m, std::sqrt(0.01 + g.sd_m * g.sd_m));
  EXPECT_GT(position_sd_on_earth_m(g, g.anchored_point_m + Eigen::Vector3d(500, 0, 0), 0.1), 2.0 * near_m);
}

TEST(SolveControlPoints, RefusesOnePointCoincidingPointsAndSwappedCoordinates) {
  EXPECT_FALSE(solve_control_points(exact_points(1), {}));
  auto coinciding = exact_points(2);
  coinciding[1].in_reference_m = coinciding[0].in_reference_m;
  EXPECT_FALSE(solve_control_points(coinciding, {}));
  auto swapped = exact_points(2);
  for (ControlPoint& p : swapped) std::swap(p.on_earth.latitude_deg, p.on_earth.longitude_deg);
  const auto refused = solve_control_points(swapped, {});
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.issues.front()).find("longitude and latitude"), std::string::npos);
}

}  // namespace
}  // namespace stemwise
