#include "core/treeloc/perturb_frames.hpp"

#include <algorithm>

#include "core/base/random.hpp"

namespace stemwise::treeloc {

FrameSet delete_trees(const FrameSet& frames, double share, std::uint64_t seed) {
  FrameSet kept;
  for (const Frame& frame : frames.frames) {
    Random random(seed, static_cast<std::uint64_t>(frame.number) + 1);
    Frame& thinned = kept.frames.emplace_back(Frame{frame.number, frame.pose, {}});
    for (const Stem& stem : frame.stems) {
      if (random.uniform() >= share) thinned.stems.push_back(stem);
    }
  }
  return kept;
}

FrameSet add_noise(const FrameSet& frames, double center_sd_m, double dbh_sd_m, std::uint64_t seed) {
  constexpr double thinnest_m = 0.01;
  FrameSet noisy = frames;
  for (Frame& frame : noisy.frames) {
    Random random(seed, static_cast<std::uint64_t>(frame.number) + 1);
    for (Stem& stem : frame.stems) {
      stem.x_m += random.normal(0.0, center_sd_m);
      stem.y_m += random.normal(0.0, center_sd_m);
      const double thicker_m = random.normal(0.0, dbh_sd_m);
      if (stem.dbh_m) stem.dbh_m = std::max(thinnest_m, *stem.dbh_m + thicker_m);
      if (stem.dbh_approximation_m) stem.dbh_approximation_m = std::max(thinnest_m, *stem.dbh_approximation_m + thicker_m);
    }
  }
  return noisy;
}

FrameSet rotate_frames(const FrameSet& frames, const RollPitchYaw& old_from_new) {
  const Eigen::Matrix3d old_from_turned = rotation_from(old_from_new), turned_from_old = old_from_turned.transpose();
  FrameSet turned = frames;
  for (Frame& frame : turned.frames) {
    frame.pose.survey_from_frame.rotation = frame.pose.survey_from_frame.rotation * old_from_turned;
    for (Stem& stem : frame.stems) {
      const Eigen::Vector3d at = turned_from_old * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
      stem.x_m = at.x();
      stem.y_m = at.y();
      if (stem.z_m) stem.z_m = at.z();
      if (stem.axis) stem.axis = turned_from_old * *stem.axis;
    }
  }
  return turned;
}

}  // namespace stemwise::treeloc
