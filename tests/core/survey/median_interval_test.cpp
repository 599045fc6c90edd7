#include "core/survey/median_interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"

namespace stemwise {
namespace {

constexpr double true_median_m = 0.01;

/// Growth with a long tail (lognormal about 1 cm), measured twice with 1 cm of error each.
std::vector<double> measured_changes(int stems, std::uint64_t seed) {
  Random random(seed, 0);
  std::vector<double> changes_m;
  for (int i = 0; i < stems; ++i)
    changes_m.push_back(true_median_m * std::exp(random.normal(0.0, 0.6)) + random.normal(0.0, 0.01) - random.normal(0.0, 0.01));
  return changes_m;
}

bool holds(const std::array<double, 2>& interval, double value) { return interval[0] <= value && value <= interval[1]; }

int samples_that_hold_the_truth(int stems) {
  int held = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) held += holds(median_interval(measured_changes(stems, seed)), true_median_m) ? 1 : 0;
  return held;
}

TEST(MedianInterval, HoldsTheTrueMedianOfASkewedStandAtAnyNumberOfStems) {
  for (const int stems : {60, 250, 1000, 4000}) EXPECT_GE(samples_that_hold_the_truth(stems), 92) << stems << " stems";
}

TEST(MedianInterval, IsNotWidenedMuchWhereChangesAreSymmetric) {
  Random random(3, 0);
  std::vector<double> changes_m;
  for (int i = 0; i < 2000; ++i) changes_m.push_back(0.02 + random.normal(0.0, 0.01));
  const auto interval = median_interval(changes_m);
  EXPECT_TRUE(holds(interval, 0.02));
  EXPECT_LT(interval[1] - interval[0], 0.004);
}

TEST(MedianInterval, AFewGrossErrorsHardlyMoveIt) {
  std::vector<double> changes_m = measured_changes(1000, 7);
  const auto clean = median_interval(changes_m);
  for (std::size_t i = 0; i < changes_m.size(); i += 50) changes_m[i] += i % 100 == 0 ? 0.5 : -0.5;
  const auto dirty = median_interval(changes_m);
  EXPECT_NEAR(dirty[0], clean[0], 0.003);
  EXPECT_NEAR(dirty[1], clean[1], 0.003);
}

TEST(MedianInterval, OfFewOrEqualChangesIsTheirRange) {
  EXPECT_EQ(median_interval({}), (std::array{0.0, 0.0}));
  EXPECT_EQ(median_interval({0.01}), (std::array{0.01, 0.01}));
  const auto equal = median_interval(std::vector<double>(50, 0.02));
  EXPECT_NEAR(equal[0], 0.02, 1e-12);
  EXPECT_NEAR(equal[1], 0.02, 1e-12);
}

}  // namespace
}  // namespace stemwise
