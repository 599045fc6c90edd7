#include "io/underlay/shade_heights.hpp"

#include <algorithm>
#include <cmath>

namespace stemwise {
namespace {

constexpr double light_x = -0.5, light_y = 0.5, light_z = 0.70710678118654752;  // from the north-west, 45 degrees high
constexpr double height_share = 0.30;  // of the grey; the rest is light

std::pair<double, double> spread_of(std::span<const float> values) {
  std::vector<float> known;
  known.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(known), [](float v) { return std::isfinite(v); });
  if (known.empty()) return {0.0, 1.0};
  const auto at = [&](double share) {
    const auto place = known.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(known.size() - 1));
    std::nth_element(known.begin(), place, known.end());
    return static_cast<double>(*place);
  };
  const double low = at(0.02), high = at(0.98);
  return {low, high > low ? high : low + 1.0};
}

}  // namespace

std::vector<std::uint8_t> shade_heights(std::span<const float> heights_m, int width, int height, double pixel_m) {
  std::vector<std::uint8_t> grey(heights_m.size(), 0);
  const auto [low, high] = spread_of(heights_m);
  const auto at = [&](int x, int y) { return heights_m[static_cast<std::size_t>(y) * width + x]; };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float own = at(x, y);
      if (!std::isfinite(own)) continue;
      const auto known = [&](int nx, int ny) {
        const float there = at(std::clamp(nx, 0, width - 1), std::clamp(ny, 0, height - 1));
        return static_cast<double>(std::isfinite(there) ? there : own);
      };
      const double east = (known(x + 1, y) - known(x - 1, y)) / (2.0 * pixel_m), north = (known(x, y - 1) - known(x, y + 1)) / (2.0 * pixel_m);
      const double light = (-east * light_x - north * light_y + light_z) / std::sqrt(1.0 + east * east + north * north);
      const double share = (1.0 - height_share) * std::clamp(light, 0.0, 1.0) + height_share * std::clamp((own - low) / (high - low), 0.0, 1.0);
      grey[static_cast<std::size_t>(y) * width + x] = static_cast<std::uint8_t>(std::lround(255.0 * share));
    }
  return grey;
}

std::vector<std::uint8_t> stretch_values(std::span<const float> values) {
  const auto [low, high] = spread_of(values);
  std::vector<std::uint8_t> grey(values.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) grey[i] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp((values[i] - low) / (high - low), 0.0, 1.0)));
  return grey;
}

}  // namespace stemwise
