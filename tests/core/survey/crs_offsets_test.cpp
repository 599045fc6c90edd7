#include "core/survey/crs_offsets.hpp"

#include <gtest/gtest.h>

namespace stemwise {
namespace {

/// Surveys of one square plot in UTM-sized coordinates, each laid onto the reference by a shift.
struct Case {
  std::vector<Inventory> inventories;
  SurveyAlignment alignment;
  std::vector<const Inventory*> pointers() const {
    std::vector<const Inventory*> all;
    for (const Inventory& inventory : inventories) all.push_back(&inventory);
    return all;
  }
};

Case shifted_by(const std::vector<Eigen::Vector2d>& shifts_m) {
  Case c;
  for (std::size_t k = 0; k < shifts_m.size(); ++k) {
    Inventory inventory{InventoryId{static_cast<std::int64_t>(k + 1)}, "plot " + std::to_string(k + 1), {}, {}, {}, nullptr};
    for (int i = 0; i < 4; ++i) {
      Stem stem;
      stem.x_m = 500000.0 + 20.0 * (i % 2);
      stem.y_m = 5400000.0 + 20.0 * (i / 2);
      inventory.stems.push_back(stem);
    }
    InventoryAlignment pose;
    pose.inventory = inventory.id;
    pose.status = k == 0 ? AlignmentStatus::reference : AlignmentStatus::aligned;
    pose.reference_from_inventory = RigidTransform::planar(shifts_m[k].x(), shifts_m[k].y(), 0.0);
    c.inventories.push_back(inventory);
    c.alignment.inventories.push_back(pose);
  }
  return c;
}

TEST(CrsOffsets, NameTheOneThatDisagreesEvenWhereItIsTheReference) {
  const Case c = shifted_by({{0, 0}, {2.8, 0.3}, {2.9, 0.1}});
  const auto offsets = crs_offsets(c.pointers(), c.alignment);
  ASSERT_EQ(offsets.size(), 3U);
  EXPECT_TRUE(offsets[0].is_wrong);
  EXPECT_FALSE(offsets[1].is_wrong || offsets[2].is_wrong);
  const auto warnings = crs_warnings(c.pointers(), c.alignment);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].rfind("plot 1:", 0), 0U) << warnings[0];
}

TEST(CrsOffsets, SayNothingWhereGnssIsOffAsItUsuallyIs) {
  const Case c = shifted_by({{0, 0}, {0.8, -0.6}, {-0.5, 1.2}});
  EXPECT_TRUE(crs_warnings(c.pointers(), c.alignment).empty());
}

TEST(CrsOffsets, OfTwoNobodyCanSayWhich) {
  const Case c = shifted_by({{0, 0}, {6.8, 0}});
  const auto warnings = crs_warnings(c.pointers(), c.alignment);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("plot 1 and plot 2"), std::string::npos) << warnings[0];
}

}  // namespace
}  // namespace stemwise
