#pragma once
#include "io/underlay/cloud_collector.hpp"

namespace stemwise {

/// A LAS file's points (formats 0 to 10) near the stems; points that the file calls withheld or noise are left out. A file that
/// ends early gives what is there and a warning. Throws Cancelled.
Result<CloudUnderlay> read_las_points(const UnderlayRequest& request, const Progress& progress);

}  // namespace stemwise
