#pragma once
#include <string>

#include "app/session.hpp"

namespace stemwise {

struct GeoreferenceOptions {
  std::string project;
  std::string anchor;   ///< LAT,LON,H,AZIMUTH
  std::string crs;      ///< EPSG:N
  std::string control;  ///< CSV
};

/// `stemwise georeference PROJECT`: places the project on the earth by exactly one of the three.
ExitCode run_georeference(const GeoreferenceOptions& options, Session& session);

}  // namespace stemwise
