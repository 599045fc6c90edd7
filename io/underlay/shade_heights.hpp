#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace stemwise {

/// Shaded relief of a grid of heights, light from the north-west, brighter where it is higher: a grey per cell, top row
/// first. Cells that are not finite are 0. `pixel_m`: what a cell covers.
std::vector<std::uint8_t> shade_heights(std::span<const float> heights_m, int width, int height, double pixel_m);

/// Greys between the 2nd and 98th percentile of what is finite.
std::vector<std::uint8_t> stretch_values(std::span<const float> values);

}  // namespace stemwise
