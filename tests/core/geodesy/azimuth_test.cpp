#include "core/geodesy/azimuth.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stemwise {
namespace {

TEST(Azimuth, ConvergenceIsZeroOnTheMiddleMeridianAndEastwardsPositiveInTheNorth) {
  EXPECT_NEAR(*utm_convergence_deg({48.0, 9.0, 0.0}), 0.0, 1e-9);
  // gamma = (longitude - middle) sin(latitude) to first order (Snyder 1987, eq. 8-15 linearised)
  EXPECT_NEAR(*utm_convergence_deg({48.0, 11.0, 0.0}), 2.0 * std::sin(48.0 * M_PI / 180.0), 0.002);
  EXPECT_LT(*utm_convergence_deg({-48.0, 11.0, 0.0}), 0.0);
  EXPECT_FALSE(utm_convergence_deg({89.0, 11.0, 0.0}));
}

TEST(Azimuth, AGeoidThatIsNotOnTheMachineSaysHowToGetIt) {
  const auto geoid = local_geoid_of_model("no-such-geoid", {48.0, 9.0, 0.0});
  ASSERT_FALSE(geoid);
  EXPECT_NE(geoid.issues.front().help.find("geographiclib-get-geoids no-such-geoid"), std::string::npos);
}

TEST(Azimuth, AMagneticModelThatIsNotOnTheMachineSaysWhatElseHelps) {
  const auto declination = declination_deg({48.0, 9.0, 0.0}, date_from_civil(2021, 6, 1), "no-such-model");
  ASSERT_FALSE(declination);
  EXPECT_NE(declination.issues.front().help.find("--declination"), std::string::npos);
}

TEST(Azimuth, TheLocalGeoidIsAPlaneThroughItsThreeHeights) {
  Georeference g;
  g.kind = GeoreferenceKind::anchor;
  g.origin = {48.0, 9.0, 500.0};
  g.geoid = local_geoid("test", 47.0, 47.05, 46.98);
  EXPECT_DOUBLE_EQ(geoid_height_m(g, g.origin), 47.0);
  EXPECT_NEAR(geoid_height_m(g, beside(g.origin, 500.0, 0.0)), 47.05, 1e-7);
  EXPECT_NEAR(geoid_height_m(g, beside(g.origin, 1000.0, 500.0)), 47.08, 1e-7);
}

}  // namespace
}  // namespace stemwise
