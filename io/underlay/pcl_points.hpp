#pragma once
#include "io/underlay/cloud_collector.hpp"

namespace stemwise {

/// PCL reads these files whole: larger ones are refused with words on how to make them smaller.
inline constexpr std::uint64_t most_whole_cloud_bytes = 2'000'000'000;

/// A PCD or PLY file's points near the stems, by PCL. Throws Cancelled.
Result<CloudUnderlay> read_pcl_points(const UnderlayRequest& request, const Progress& progress);

}  // namespace stemwise
