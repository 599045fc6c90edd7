#include "core/simulate/drift.hpp"

#include "core/base/random.hpp"

namespace stemwise {

FrameSet with_drift(FrameSet frames, double share, std::uint64_t seed) {
  if (share == 0.0 || frames.frames.size() < 2) return frames;
  Random random(seed, 500);
  const double stretch = 1.0 + (random.uniform() < 0.5 ? -share : share), turn = random.uniform() < 0.5 ? -share : share;
  std::vector<RigidTransform> steps;
  double way_m = 0.0;
  for (std::size_t i = 1; i < frames.frames.size(); ++i) {
    steps.push_back(frames.frames[i - 1].pose.survey_from_frame.inverse() * frames.frames[i].pose.survey_from_frame);
    way_m += steps.back().translation_m.norm();
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    RigidTransform step = steps[i];
    const double yaw_rad = way_m > 0.0 ? turn * step.translation_m.norm() / way_m : 0.0;
    step.translation_m *= stretch;
    step.rotation = step.rotation * rotation_from({0.0, 0.0, yaw_rad});
    frames.frames[i + 1].pose.survey_from_frame = frames.frames[i].pose.survey_from_frame * step;
  }
  return frames;
}

}  // namespace stemwise
