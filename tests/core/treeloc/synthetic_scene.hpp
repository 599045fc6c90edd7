#pragma once
#include <cmath>
#include <vector>

#include "core/base/random.hpp"
#include "core/forest/frame_set.hpp"

namespace stemwise::testing {

/// A random stand: stems at least 1.5 m apart on a square of `side_m` around the origin, on a slope, with upright axes.
inline std::vector<Stem> random_stand(double side_m, int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Stem> stems;
  while (static_cast<int>(stems.size()) < count) {
    Stem s;
    s.x_m = random.uniform(-side_m / 2, side_m / 2);
    s.y_m = random.uniform(-side_m / 2, side_m / 2);
    bool free = true;
    for (const Stem& other : stems) free = free && std::hypot(s.x_m - other.x_m, s.y_m - other.y_m) > 1.5;
    if (!free) continue;
    s.z_m = 0.05 * s.x_m - 0.02 * s.y_m;
    s.dbh_m = random.uniform(0.1, 0.6);
    s.axis = Eigen::Vector3d(random.normal(0.0, 0.02), random.normal(0.0, 0.02), 1.0).normalized();
    s.number_clusters = 4;
    stems.push_back(s);
  }
  return stems;
}

/// What a sensor at `survey_from_frame` sees of a stand within `range_m`: positions, heights and diameters with noise.
inline Frame frame_of(const std::vector<Stem>& stand, const RigidTransform& survey_from_frame, double range_m, double noise_m,
                      std::int64_t number, std::uint64_t seed, double drop = 0.0) {
  Random random(seed, static_cast<std::uint64_t>(number) + 1);
  Frame frame;
  frame.number = number;
  frame.pose.survey_from_frame = survey_from_frame;
  const RigidTransform frame_from_survey = survey_from_frame.inverse();
  for (Stem s : stand) {
    const bool far =
        std::hypot(s.x_m - survey_from_frame.translation_m.x(), s.y_m - survey_from_frame.translation_m.y()) > range_m;
    if (far || random.uniform() < drop) continue;
    const Eigen::Vector3d noise(random.normal(0.0, noise_m), random.normal(0.0, noise_m), random.normal(0.0, noise_m));
    const Eigen::Vector3d p = frame_from_survey * (Eigen::Vector3d(s.x_m, s.y_m, *s.z_m) + noise);
    s.x_m = p.x();
    s.y_m = p.y();
    s.z_m = p.z();
    s.dbh_m = std::max(0.05, *s.dbh_m + random.normal(0.0, 0.01));
    s.axis = frame_from_survey.rotation * *s.axis;
    frame.stems.push_back(s);
  }
  return frame;
}

/// A walk on a circle through a stand, the sensor 1.5 m above the slope, turned by roll, pitch and any yaw.
inline FrameSet walk(const std::vector<Stem>& stand, double radius_m, int frames, double noise_m, std::uint64_t seed,
                     double drop = 0.0) {
  Random random(seed);
  FrameSet set;
  for (int i = 0; i < frames; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / frames;
    RigidTransform pose;
    pose.translation_m = {radius_m * std::cos(angle), radius_m * std::sin(angle), 0.0};
    pose.translation_m.z() = 1.5 + 0.05 * pose.translation_m.x() - 0.02 * pose.translation_m.y();
    pose.rotation = rotation_from({random.uniform(-0.15, 0.15), random.uniform(-0.15, 0.15), random.uniform(-3.1, 3.1)});
    set.frames.push_back(frame_of(stand, pose, 20.0, noise_m, i, seed, drop));
  }
  return set;
}

}  // namespace stemwise::testing
