#include "core/geodesy/georeference.hpp"

#include <gtest/gtest.h>

namespace stemwise {
namespace {

const Georeference anchor{GeoreferenceKind::anchor, {48.77, 9.17, 410.0}, {0, 0, 0}, 30.0, 0, 0.0, "anchor"};

TEST(Georeference, PutsTheOriginOnTheAnchorAndComesBackWithinAMillimetre) {
  const Geodetic origin = geodetic_from_reference(anchor, {0, 0, 0});
  EXPECT_NEAR(origin.latitude_deg, 48.77, 1e-12);
  const Eigen::Vector3d point(312.5, -87.25, 4.0);
  EXPECT_LT((reference_from_geodetic(anchor, geodetic_from_reference(anchor, point)) - point).norm(), 1e-6);
}

TEST(Georeference, TurnsTheYAxisClockwiseFromNorthByTheAzimuth) {
  Georeference east = anchor;
  east.azimuth_deg = 90.0;
  const Geodetic along_y = geodetic_from_reference(east, {0, 100, 0});
  EXPECT_GT(along_y.longitude_deg, 9.17);
  EXPECT_NEAR(along_y.latitude_deg, 48.77, 1e-5);
}

TEST(Georeference, KeepsOneUtmZoneForAProjectAlsoAcrossItsEdge) {
  const Geodetic west{48.0, 11.99, 0.0}, beyond{48.0, 12.01, 0.0};
  const auto a = utm_from_geodetic(west, west), b = utm_from_geodetic(beyond, west);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->epsg(), 32632);
  EXPECT_EQ(b->epsg(), 32632);
  EXPECT_GT(b->easting_m, a->easting_m);
}

}  // namespace
}  // namespace stemwise
