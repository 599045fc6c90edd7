#pragma once
#include <Eigen/Core>
#include <span>

#include "core/base/field.hpp"
#include "core/forest/inventory.hpp"
#include "core/project/project_state.hpp"

namespace stemwise {

struct CoverageSettings {
  double seen_share = 0.9;      ///< a frame covers the radius within which this share of its reconstructed stems lies
  double least_range_m = 5.0;   ///< and at least so much
  double frame_cell_m = 1.5;    ///< raster of the union of discs
  double smallest_hole_sq_m = 200.0;  ///< smaller holes count as looked at
  double close_spacings = 3.0;  ///< stems nearer than twice this many typical spacings belong together
  Fields fields();
};

/// Where the frames looked: the union of discs around the poses. In the survey's frame. One ring; holes of a loop are kept
/// open through a slit of a centimetre.
Coverage coverage_from_frames(const FrameSet& frames, const CoverageSettings& settings = {});
/// Where a bare list has stems: its concave footprint and half the typical spacing around it. Fewer than three stems: a
/// disc of five metres around each.
Coverage coverage_from_stems(std::span<const Stem> stems, const CoverageSettings& settings = {});
/// From its frames where it has them, else from its stems.
Coverage estimate_coverage(const Inventory& inventory);

}  // namespace stemwise
