#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/treeloc/scene.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// How high above the stem bases around it the sensor stood, along a survey.
struct SensorHeight {
  int frames = 0;          ///< with enough stem bases within 10 m
  double median_m = 0.0;
  double spread_m = 0.0;   ///< 1.4826 times the median absolute deviation, upwards and downwards alike
  bool is_constant = false;
};

/// From the frames themselves, no trajectory: `ground_m` of every scene. The spread is robust, because base heights of route
/// data are biased by metres over stretches of a survey; it must stay below the settings', and the sensor low enough to have
/// been carried, in frames enough and in at least half of them.
SensorHeight sensor_height(std::span<const Scene> scenes, const SensorHeightSettings& settings);

/// Marks the scenes of one survey by that test.
void mark_level_sensor(std::span<Scene> scenes, const SensorHeightSettings& settings);

}  // namespace stemwise::treeloc
