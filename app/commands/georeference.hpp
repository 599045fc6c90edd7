#pragma once
#include <optional>
#include <string>

#include "app/session.hpp"

namespace stemwise {

struct GeoreferenceOptions {
  std::string project;
  // Exactly one of these.
  std::string anchor;   ///< LAT,LON,H,AZIMUTH
  std::string crs;      ///< EPSG:N
  std::string control;  ///< CSV
  std::string gnss;     ///< CSV
  // Directions.
  std::optional<double> azimuth_deg;       ///< for --translation-only
  bool translation_only = false;
  std::string azimuth_kind = "true";       ///< true, grid, magnetic
  std::optional<double> declination_deg;
  std::string magnetic_model = "wmm2020";
  // Heights.
  std::string geoid;
  bool level = false, tilted = false;
  // What is placed, and how well.
  std::string inventory;                   ///< whose coordinates --crs names, whose trajectory --gnss follows; none: the reference
  std::string trajectory;
  double time_offset_s = 0.0;
  std::optional<double> sd_m;
  double outlier_m = 3.0;
};

/// `stemwise georeference PROJECT`: places the project on the earth by exactly one of anchor, CRS, control points, track.
ExitCode run_georeference(const GeoreferenceOptions& options, Session& session);

}  // namespace stemwise
