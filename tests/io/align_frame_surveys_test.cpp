#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/survey/align_surveys.hpp"
#include "core/survey/build_global_inventory.hpp"
#include "core/survey/coverage.hpp"
#include "core/survey/move_frames.hpp"
#include "io/read_frame_folder.hpp"

// Acceptance of issue 2: two real surveys along forest roads, months apart, the second one told in a frame of its own.
namespace stemwise {
namespace {

std::string shared_data() {
  const char* folder = std::getenv("STEMWISE_SHARED_DATA");
  return folder != nullptr ? folder : STEMWISE_SOURCE_DIR "/../shared/data";
}

bool near(const Frame& frame, const Eigen::Vector2d& centre_m, double radius_m) {
  return (frame.pose.survey_from_frame.translation_m.head<2>() - centre_m).norm() <= radius_m;
}

/// The survey as read, or only what lies around a place; told in another frame; its stems made of its frames.
Inventory survey(const std::string& name, std::int64_t id, const RigidTransform& told_from_survey, double radius_m) {
  Inventory inventory = *read_frame_folder(shared_data() + "/" + name);
  inventory.id.value = id;
  FrameSet frames = *inventory.frames;
  const Eigen::Vector2d centre_m(360, -185);
  std::erase_if(frames.frames, [&](const Frame& f) { return !near(f, centre_m, radius_m); });
  inventory.frames = std::make_shared<const FrameSet>(move_frames(std::move(frames), told_from_survey));
  return with_global_stems(std::move(inventory));
}

struct Outcome {
  InventoryAlignment alignment;
  double rms_m = 0.0;           ///< of the shared trees, against the trajectories' common frame
  double matched_share = 0.0;   ///< of the reference's well-observed trees inside both coverages
  int well_observed = 0;
};

Outcome align_moved(double yaw_deg, double radius_m) {
  const RigidTransform moved{rotation_from({radians(10), radians(10), radians(yaw_deg)}), {400, -300, 20}};
  const Inventory a = survey("venman-03", 1, {}, radius_m), b = survey("venman-04", 2, moved, radius_m);
  const std::vector<const Inventory*> both{&a, &b};
  const SurveyAlignment result = align_surveys(both, a.id, {}, {}, {});
  Outcome outcome{result.inventories[1], 0.0, 0.0, 0};
  const RigidTransform& found = outcome.alignment.reference_from_inventory;
  std::vector<char> matched(a.stems.size(), 0);
  for (const Match& m : result.matches) {
    const bool a_first = m.a.inventory == a.id;
    matched[static_cast<std::size_t>((a_first ? m.a : m.b).index)] = 1;
    const Stem& stem = b.stems[static_cast<std::size_t>((a_first ? m.b : m.a).index)];
    const Eigen::Vector3d p(stem.x_m, stem.y_m, *stem.z_m);
    outcome.rms_m += (found * p - moved.inverse() * p).squaredNorm() / static_cast<double>(result.matches.size());
  }
  outcome.rms_m = std::sqrt(outcome.rms_m);
  const Coverage in_a = estimate_coverage(a), in_b = estimate_coverage(b);
  int hits = 0;
  for (std::size_t i = 0; i < a.stems.size(); ++i) {
    const Stem& s = a.stems[i];
    if (!s.reconstructed || s.times_seen < 3 || !contains(in_a.in_inventory, {s.x_m, s.y_m})) continue;
    const Eigen::Vector3d there = found.inverse() * Eigen::Vector3d(s.x_m, s.y_m, *s.z_m);
    if (!contains(in_b.in_inventory, there.head<2>())) continue;
    ++outcome.well_observed;
    hits += matched[i];
  }
  outcome.matched_share = static_cast<double>(hits) / std::max(1, outcome.well_observed);
  return outcome;
}

void expect_aligned(const Outcome& outcome) {
  EXPECT_EQ(outcome.alignment.status, AlignmentStatus::aligned) << outcome.alignment.reason;
  EXPECT_LT(outcome.rms_m, 0.6);
  EXPECT_GE(outcome.matched_share, 0.6);
  for (const Dof dof : {Dof::x, Dof::y, Dof::yaw, Dof::z, Dof::roll, Dof::pitch}) EXPECT_TRUE(outcome.alignment.observed[dof]);
}

bool data_is_there() { return std::filesystem::exists(shared_data() + "/venman-03/trajectory.txt") && std::filesystem::exists(shared_data() + "/venman-04/trajectory.txt"); }

TEST(AlignFrameSurveys, APartOfTwoRealSurveysFallsTogetherAfterTurningTiltingAndShifting) {
  if (!data_is_there()) GTEST_SKIP() << "no venman-03 and venman-04 in " << shared_data();
  const Outcome outcome = align_moved(-71, 80.0);
  EXPECT_GT(outcome.well_observed, 100);
  expect_aligned(outcome);
}

TEST(AlignFrameSurveys, TwoWholeRealSurveysFallTogetherAfterTurningTiltingAndShifting) {
  if (!data_is_there()) GTEST_SKIP() << "no venman-03 and venman-04 in " << shared_data();
  const Outcome outcome = align_moved(137, 1e9);
  EXPECT_GT(outcome.well_observed, 3000);
  expect_aligned(outcome);
}

}  // namespace
}  // namespace stemwise
