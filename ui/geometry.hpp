#pragma once
#include <cstdint>

namespace stemwise::ui {

/// A rectangle on the screen, in pixels from the window's upper left corner.
struct Rect {
  float x = 0.0f;
  float y = 0.0f;
  float width = 0.0f;
  float height = 0.0f;

  float right() const { return x + width; }
  float bottom() const { return y + height; }
  float center_x() const { return x + 0.5f * width; }
  float center_y() const { return y + 0.5f * height; }
  bool contains(float px, float py) const { return px >= x && py >= y && px < right() && py < bottom(); }
  bool overlaps(const Rect& o) const { return x < o.right() && o.x < right() && y < o.bottom() && o.y < bottom(); }
  bool operator==(const Rect&) const = default;
};

struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;

  /// As Dear ImGui packs colours (ABGR in one word).
  std::uint32_t packed() const {
    return std::uint32_t{r} | std::uint32_t{g} << 8 | std::uint32_t{b} << 16 | std::uint32_t{a} << 24;
  }
  Color with_alpha(float alpha) const { return {r, g, b, static_cast<std::uint8_t>(a * alpha + 0.5f)}; }
  bool operator==(const Color&) const = default;
};

/// 0xRRGGBB.
constexpr Color hex(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8), static_cast<std::uint8_t>(rgb), 255};
}

}  // namespace stemwise::ui
