#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/date.hpp"
#include "core/base/field.hpp"
#include "core/base/issue.hpp"

namespace stemwise {

/// A synthetic forest and how its surveys see it. Defaults are those of `stemwise simulate` (cli.md).
struct SimulateSettings {
  std::uint64_t seed = 0;
  std::vector<Date> dates;               ///< one survey each, ascending; empty: 2015, 2019 and 2023 (1 July)
  int stems = 600;                       ///< alive at the first survey
  double area_ha = 0.0;                  ///< 0: 450 stems to the hectare
  bool planted = false;                  ///< rows of one age instead of a natural stand
  double terrain_relief_m = 12.0;        ///< highest minus lowest ground, about
  double growth_cm_per_year = 0.35;      ///< median of the stand
  double mortality_per_year = 0.010;     ///< share of the stems
  double removals_per_year = 0.006;      ///< share of the stems, as felled patches and single trees
  double ingrowth_per_year = 0.012;      ///< share of the stems
  double smallest_dbh_cm = 7.0;          ///< stems are recorded from here
  double standing_dead = 0.3;            ///< share of the dead that the next survey records as dead
  // What a survey does to the truth.
  double position_noise_m = 0.1;         ///< one axis
  double height_noise_m = 0.1;           ///< of base heights
  double axis_noise_deg = 1.0;
  double dbh_noise_cm = 1.0;
  double drop = 0.1;                     ///< share of stems missed
  double false_stems = 0.02;             ///< share of stems added that are none
  std::optional<double> yaw_deg;         ///< empty: any
  double shift_m = 300.0;                ///< each survey's origin lies up to so far away
  double tilt_deg = 0.0;                 ///< each survey's vertical is off by so much, in any direction
  bool heights_and_axes = true;          ///< false: plain lists without z and axis, like field maps
  bool frames = false;                   ///< also as frames along a walk through the stand
  double drift = 0.0;                    ///< of the walk's trajectory: its end is off by about this share of its length
  Fields fields();
  Issues check() const;
};

}  // namespace stemwise
