#include "io/underlay/underlay_request.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

namespace stemwise {

std::string lower_suffix(const std::string& path) {
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}

std::optional<UnderlayKind> underlay_kind_of(const std::string& path) {
  static constexpr std::array<std::string_view, 8> rasters{".tif", ".tiff", ".png", ".jpg", ".jpeg", ".jp2", ".vrt", ".asc"};
  static constexpr std::array<std::string_view, 4> clouds{".las", ".laz", ".pcd", ".ply"};
  const std::string suffix = lower_suffix(path);
  if (std::find(rasters.begin(), rasters.end(), suffix) != rasters.end()) return UnderlayKind::raster;
  if (std::find(clouds.begin(), clouds.end(), suffix) != clouds.end()) return UnderlayKind::cloud;
  return std::nullopt;
}

}  // namespace stemwise
