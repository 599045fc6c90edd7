#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "render/picture.hpp"

namespace stemwise::test {

/// Share of pixels that differ visibly, 0..1; 1 for pictures of different sizes.
inline double difference(const render::Image& a, const render::Image& b) {
  if (a.size != b.size || a.rgba.empty()) return 1.0;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int(a.rgba[i + c]) - int(b.rgba[i + c])));
    differing += most > 28;
  }
  return static_cast<double>(differing) / (static_cast<double>(a.rgba.size()) / 4.0);
}

/// Compares with tests/render/golden/NAME.png; another driver or typeface may move an edge, not the picture.
/// STEMWISE_UPDATE_GOLDEN=1 writes it anew: look at it before committing.
inline void expect_golden(const render::Image& image, const std::string& name) {
  const std::string folder = std::string(STEMWISE_SOURCE_DIR) + "/tests/render/golden";
  const std::string path = folder + "/" + name + ".png";
  if (std::getenv("STEMWISE_UPDATE_GOLDEN")) {
    std::filesystem::create_directories(folder);
    ASSERT_TRUE(render::write_png(image, path));
    return;
  }
  const auto golden = render::read_png(path);
  ASSERT_TRUE(golden) << path;
  const double share = difference(image, *golden);
  EXPECT_LT(share, 0.03) << name << ": see " << name << ".seen.png in the temporary folder";
  if (share >= 0.03) (void)render::write_png(image, std::filesystem::temp_directory_path() / (name + ".seen.png"));
}

/// Larger pictures to look at, into the folder STEMWISE_GALLERY where that is set.
inline void show(const render::Image& image, const std::string& name) {
  const char* folder = std::getenv("STEMWISE_GALLERY");
  if (folder) (void)render::write_png(image, std::string(folder) + "/" + name + ".png");
}

}  // namespace stemwise::test
