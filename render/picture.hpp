#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace stemwise::render {

struct PixelSize {
  int width = 0;
  int height = 0;
  bool operator==(const PixelSize&) const = default;
};

/// Straight-alpha RGBA, 4 bytes a pixel, top row first, no padding.
struct Image {
  PixelSize size;
  std::vector<std::uint8_t> rgba;
  bool operator==(const Image&) const = default;
};

/// Written beside the target and renamed onto it: never half a file.
Result<Done> write_bytes(const std::vector<std::uint8_t>& bytes, const std::string& path);
/// As write_bytes. Same image, same bytes.
Result<Done> write_png(const Image& image, const std::string& path);
std::vector<std::uint8_t> png_bytes(const Image& image);
Result<Image> read_png(const std::string& path);

}  // namespace stemwise::render
