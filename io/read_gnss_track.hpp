#pragma once
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/geodesy/solve_gnss_track.hpp"

namespace stemwise {

/// CSV (any delimiter) with timestamp, lat, lon, and height_m, sd_m where known (cli.md, "Files"). A time stamp is seconds on
/// the trajectory's clock, or a date with time in UTC (2023-05-04T10:15:00.5Z), which becomes seconds since 1970. Bad rows
/// are warnings that name row and column; a failure when no row is usable.
Result<std::vector<GnssFix>> read_gnss_track(const std::string& path);

}  // namespace stemwise
