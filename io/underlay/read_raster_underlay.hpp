#pragma once
#include "core/base/result.hpp"
#include "core/jobs/progress.hpp"
#include "core/underlay/raster_underlay.hpp"
#include "io/underlay/underlay_request.hpp"

namespace stemwise {

inline constexpr int most_raster_px = 2048;  ///< of the longer side that is kept

/// Reads what of an image or a GeoTIFF lies around the stems, at a resolution of at most `most_raster_px`, by GDAL with the
/// file's overviews: whatever the file's size, some 16 MB. One band of heights (floating point or signed numbers) becomes
/// shaded relief, other single bands grey, palettes their colours. Failure where it cannot be read, has neither georeference nor
/// world file, lies elsewhere, or cannot be brought into the project's frame. Throws Cancelled.
Result<RasterUnderlay> read_raster_underlay(const UnderlayRequest& request, const Progress& progress = {});

}  // namespace stemwise
