#pragma once
#include <vector>

#include "core/underlay/cloud_underlay.hpp"
#include "core/underlay/thin_cloud.hpp"

namespace stemwise {

/// Makes a cloud ready to be drawn of points in the reference's frame: relative to an origin of its own, cut into tiles, in each
/// of them in an order of which any first part is an even choice, intensities stretched between their 2nd and 98th percentile,
/// and with heights above the ground. The ground is the low end (3 %) of the points in squares of 2 m, those that the file itself
/// calls ground where it has any, and never rises from one square to the next by more than a slope of 0.6.
CloudUnderlay arrange_cloud(std::vector<RawPoint> points_in_reference, double spacing_m);

}  // namespace stemwise
