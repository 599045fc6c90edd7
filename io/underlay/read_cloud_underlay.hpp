#pragma once
#include "core/base/result.hpp"
#include "core/jobs/progress.hpp"
#include "core/underlay/cloud_underlay.hpp"
#include "io/underlay/underlay_request.hpp"

namespace stemwise {

inline constexpr std::size_t most_cloud_points = 1'500'000;  ///< that are kept
inline constexpr double finest_cloud_spacing_m = 0.03;

/// Reads what of a PCD, PLY or LAS file lies around the stems, thinned while reading: LAS of any size in some 200 MB; PCD and
/// PLY, which PCL reads whole, up to `most_whole_cloud_bytes`. Failure where it cannot be read, is LAZ (with words on how to
/// convert it), lies elsewhere, or cannot be brought into the project's frame; a warning where it is cut off. Throws Cancelled.
Result<CloudUnderlay> read_cloud_underlay(const UnderlayRequest& request, const Progress& progress = {});

}  // namespace stemwise
