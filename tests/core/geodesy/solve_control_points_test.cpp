#include "core/geodesy/solve_control_points.hpp"

#include <gtest/gtest.h>

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
  EXPECT_FALSE(solved->residuals[3].used);
  EXPECT_EQ(solved->residuals[3].name, "row 5");
  EXPECT_NEAR(*solved->residuals[3].leave_one_out_m, 17.0, 0.05);
  EXPECT_LT(solved->rms_m, 0.01);
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
