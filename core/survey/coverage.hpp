#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/base/field.hpp"
#include "core/forest/inventory.hpp"
#include "core/project/project_state.hpp"
#include "core/survey/alignment.hpp"

namespace stemwise {

struct CoverageSettings {
  double seen_share = 0.9;      ///< a frame covers the radius within which this share of its reconstructed stems lies
  double least_range_m = 5.0;   ///< and at least so much
  double frame_cell_m = 1.5;    ///< raster of the union of discs
  double smallest_hole_sq_m = 200.0;  ///< smaller holes count as looked at
  /// With it the areas come out right: 0.99 to 1.01 of a square of 30 to 6,000 scattered stems, 1.01 of grids of 144 and more, 0.99 of
  /// SCBI's 25.6 ha, 0.96 (median) of the eight Mount Rainier stands; half of it gave 0.75 to 0.98. A border runs between stems, not at them.
  double margin_spacings = 1.0;
  double close_spacings = 3.0;  ///< stems nearer than twice this many typical spacings belong together
  Fields fields();
};

/// Where the frames looked: the union of discs around the poses. In the survey's frame. One ring; holes of a loop are kept
/// open through a slit of a centimetre.
Coverage coverage_from_frames(const FrameSet& frames, const CoverageSettings& settings = {});
/// Where a bare list has stems: its concave footprint and `margin_spacings` around it. Fewer than three stems: a
/// disc of five metres around each.
Coverage coverage_from_stems(std::span<const Stem> stems, const CoverageSettings& settings = {});
/// From its frames where it has them, else from its stems.
Coverage estimate_coverage(const Inventory& inventory);
/// The same of several surveys, in their order. Of bare lists that have a place, trees of other surveys at the border count too (shared_border).
std::vector<Coverage> estimate_coverages(std::span<const Inventory* const> inventories, const SurveyAlignment& alignment);

}  // namespace stemwise
