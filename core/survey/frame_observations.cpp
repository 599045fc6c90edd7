#include "core/survey/frame_observations.hpp"

#include <cmath>

#include "core/survey/level_by_axes.hpp"

namespace stemwise {
namespace {

Eigen::Matrix3d level_of(const FrameSet& frames) {
  std::vector<Eigen::Vector3d> axes;
  for (const Frame& frame : frames.frames)
    for (const Stem& stem : frame.stems)
      if (stem.axis && stem.reconstructed && stem.number_clusters > 2 && axes.size() < 200'000)
        axes.push_back(frame.pose.survey_from_frame.rotation * stem.axis->normalized());
  return level_by_axes(axes).level_from_survey;
}

RigidTransform level_from_survey_of(const FrameSet& frames) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Frame& frame : frames.frames) middle += frame.pose.survey_from_frame.translation_m / static_cast<double>(frames.frames.size());
  const Eigen::Matrix3d level = level_of(frames);
  return {level, -(level * middle)};
}

/// Far stems are placed worse, and those without a fitted surface much worse (measured on frame folders: method.md 12).
double weight_of(const Stem& stem) {
  const double range_m = std::hypot(stem.x_m, stem.y_m);
  const double sd = (stem.reconstructed ? 1.0 : 2.5) * (1.0 + range_m / 20.0);
  return 1.0 / (sd * sd);
}

Observation observe(const Stem& stem, const RigidTransform& level_from_frame) {
  Observation o;
  o.position = level_from_frame * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
  o.has_height = stem.z_m.has_value();
  o.has_axis = stem.axis.has_value() && stem.axis->norm() > 0.5;
  if (o.has_axis) {
    o.axis = level_from_frame.rotation * stem.axis->normalized();
    if (o.axis.z() < 0.0) o.axis = -o.axis;
  }
  o.reconstructed = stem.reconstructed;
  o.weight = weight_of(stem);
  return o;
}

}  // namespace

FrameObservations gather_observations(const FrameSet& frames) {
  FrameObservations result;
  if (frames.frames.empty()) {
    result.first_of_frame.push_back(0);
    return result;
  }
  result.level_from_survey = level_from_survey_of(frames);
  for (std::size_t f = 0; f < frames.frames.size(); ++f) {
    const Frame& frame = frames.frames[f];
    const RigidTransform level_from_frame = result.level_from_survey * frame.pose.survey_from_frame;
    result.first_of_frame.push_back(result.all.size());
    result.pose_positions.push_back(level_from_frame.translation_m);
    for (std::size_t s = 0; s < frame.stems.size(); ++s) {
      Observation o = observe(frame.stems[s], level_from_frame);
      o.frame = f;
      o.stem = s;
      result.all.push_back(o);
    }
  }
  result.first_of_frame.push_back(result.all.size());
  return result;
}

}  // namespace stemwise
