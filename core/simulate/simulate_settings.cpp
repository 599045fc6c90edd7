#include "core/simulate/simulate_settings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemwise {

Fields SimulateSettings::fields() {
  return {{"simulate.stems", "", "Stems alive at the first survey.", &stems},
          {"simulate.area_ha", "ha", "Area of the stand; 0 stands for 450 stems to the hectare.", &area_ha},
          {"simulate.planted", "", "Rows of one age instead of a natural stand.", &planted},
          {"simulate.terrain_relief_m", "m", "Highest minus lowest ground, about.", &terrain_relief_m},
          {"simulate.growth_cm_per_year", "cm", "Median DBH growth of a year.", &growth_cm_per_year},
          {"simulate.mortality_per_year", "", "Share of the stems that die in a year.", &mortality_per_year},
          {"simulate.removals_per_year", "", "Share of the stems felled in a year.", &removals_per_year},
          {"simulate.ingrowth_per_year", "", "Share of stems that grow in during a year.", &ingrowth_per_year},
          {"simulate.smallest_dbh_cm", "cm", "Stems are recorded from this DBH.", &smallest_dbh_cm},
          {"simulate.standing_dead", "", "Share of the dead that the next survey still records, as dead.", &standing_dead},
          {"simulate.position_noise_m", "m", "Standard deviation of a position on each axis.", &position_noise_m},
          {"simulate.height_noise_m", "m", "Standard deviation of a base height.", &height_noise_m},
          {"simulate.axis_noise_deg", "deg", "Standard deviation of a stem axis.", &axis_noise_deg},
          {"simulate.dbh_noise_cm", "cm", "Standard deviation of a DBH.", &dbh_noise_cm},
          {"simulate.drop", "", "Share of the stems that a survey misses.", &drop},
          {"simulate.false_stems", "", "Share of stems that a survey makes up.", &false_stems},
          {"simulate.shift_m", "m", "How far away a survey's origin may lie.", &shift_m},
          {"simulate.tilt_deg", "deg", "How far a survey's vertical is off.", &tilt_deg},
          {"simulate.drift", "", "How far a walk's trajectory has drifted at its end, as a share of its length.", &drift},
          {"simulate.heights_and_axes", "", "Whether surveys have base heights and stem axes.", &heights_and_axes}};
}

Issues SimulateSettings::check() const {
  Issues issues;
  const auto refuse = [&issues](const char* key, const char* text) { issues.push_back({Severity::error, "", 0, key, text, ""}); };
  if (stems < 1 || stems > 2'000'000) refuse("stems", "must be between 1 and 2,000,000");
  if (!(area_ha >= 0.0 && area_ha < 1e6)) refuse("area_ha", "must not be negative");
  if (area_ha > 0.0 && stems / area_ha > 20000.0) refuse("area_ha", "more than 20,000 stems to the hectare do not fit");
  if (!(drop >= 0.0 && drop < 1.0)) refuse("drop", "must be at least 0 and below 1");
  if (!(false_stems >= 0.0 && false_stems <= 1.0)) refuse("false_stems", "is a share and must be between 0 and 1");
  if (yaw_deg && !(std::abs(*yaw_deg) <= 360.0)) refuse("yaw_deg", "must be between -360 and 360");
  for (const auto& [share, key] : {std::pair(mortality_per_year, "mortality_per_year"), std::pair(removals_per_year, "removals_per_year"), std::pair(ingrowth_per_year, "ingrowth_per_year"),
                                   std::pair(standing_dead, "standing_dead")})
    if (!(share >= 0.0 && share <= 1.0)) refuse(key, "is a share and must be between 0 and 1");
  const auto is_length = [](double length) { return length >= 0.0 && length < 1e6; };  // false for what is no number
  if (!is_length(terrain_relief_m) || !is_length(height_noise_m)) refuse("terrain_relief_m", "relief and noise must not be negative");
  if (!(axis_noise_deg >= 0.0 && axis_noise_deg <= 90.0)) refuse("axis_noise_deg", "must be between 0 and 90");
  if (!is_length(growth_cm_per_year) || !is_length(smallest_dbh_cm)) refuse("growth_cm_per_year", "growth and the smallest DBH must not be negative");
  if (!is_length(position_noise_m) || !is_length(dbh_noise_cm) || !is_length(shift_m)) refuse("position_noise_m", "noise and shift must not be negative");
  if (!(tilt_deg >= 0.0 && tilt_deg <= 45.0)) refuse("tilt_deg", "must be between 0 and 45");
  if (!(drift >= 0.0 && drift <= 0.5)) refuse("drift", "must be between 0 and 0.5");
  if (!std::is_sorted(dates.begin(), dates.end())) refuse("years", "must ascend");
  return issues;
}

}  // namespace stemwise
