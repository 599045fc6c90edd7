#pragma once
#include <string>
#include <vector>

#include "app/commands/evaluate_setup.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {

/// One row of a sweep's table: what is changed against the plain run.
struct SweepCase {
  std::string what;  ///< "ablations", ...
  std::string name;  ///< "without PDH", "30 % deleted", ...
  SettingTexts settings;
  double deleted_share = 0.0;    ///< of the query's and the map's trees
  double center_noise_m = 0.0;   ///< of the query's trees
  double dbh_noise_m = 0.0;      ///< of the query's trees
  RollPitchYaw map_turned;       ///< how the map's sensor was mounted
  bool is_random = false;        ///< repeated with several seeds
  bool turns() const { return map_turned.roll_rad != 0.0 || map_turned.pitch_rad != 0.0 || map_turned.yaw_rad != 0.0; }
};

/// Names that `sweep --what` takes: ablations, deletion, noise, rotation, radius, sigma_t, defaults.
std::vector<std::string> sweep_names();

/// The rows of one table, the plain run first. What there is to switch off depends on the method.
std::vector<SweepCase> sweep_cases(const std::string& what, treeloc::Method method, treeloc::Settings plain);

}  // namespace stemwise
