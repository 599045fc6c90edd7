#include "core/treeloc/sensor_height.hpp"

#include <cmath>

#include "core/base/quantile.hpp"

namespace stemwise::treeloc {

Fields SensorHeightSettings::fields(const std::string& prefix) {
  return {{prefix + ".highest_m", "m", "A sensor higher above the stem bases than this was not carried", &highest_m},
          {prefix + ".most_spread_m", "m", "A sensor whose height varies by more than this (robust) was not carried level",
           &most_spread_m},
          {prefix + ".least_frames", "", "Frames with stem bases nearby that the test needs", &least_frames}};
}

SensorHeight sensor_height(std::span<const Scene> scenes, const SensorHeightSettings& settings) {
  std::vector<double> heights_m, deviations_m;
  for (const Scene& scene : scenes) {
    if (scene.ground_observed) heights_m.push_back(-scene.ground_m);
  }
  SensorHeight height;
  height.frames = static_cast<int>(heights_m.size());
  height.median_m = median(heights_m);
  for (const double h : heights_m) deviations_m.push_back(std::abs(h - height.median_m));
  height.spread_m = 1.4826 * median(deviations_m);
  height.is_constant = height.frames >= settings.least_frames && 2 * heights_m.size() >= scenes.size() && height.median_m > 0.0 &&
                       height.median_m <= settings.highest_m && height.spread_m <= settings.most_spread_m;
  return height;
}

void mark_level_sensor(std::span<Scene> scenes, const SensorHeightSettings& settings) {
  const bool is_level = sensor_height(scenes, settings).is_constant;
  for (Scene& scene : scenes) scene.level_sensor = is_level;
}

}  // namespace stemwise::treeloc
