#pragma once
#include <cstdint>
#include <span>
#include <vector>

struct ImDrawData;
struct ImDrawList;
struct ImDrawCmd;

namespace stemwise {

/// Pixels from the upper left corner; the ends do not belong to it.
struct ScreenRect {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool is_empty() const { return left >= right || top >= bottom; }
  bool operator==(const ScreenRect&) const = default;
};
ScreenRect intersection(const ScreenRect& a, const ScreenRect& b);

/// A texture whose picture changes. `is_opaque_picture`: bottom row first, no pixel lets anything through.
struct LiveTexture {
  std::uint64_t texture = 0;
  std::uint64_t version = 0;  ///< another one for another picture
  int width_px = 0, height_px = 0;
  bool is_opaque_picture = false;
};
using LiveTextures = std::span<const LiveTexture>;

/// Which parts of the window differ from the frame before: for each square of the window a number out of everything that is
/// drawn into it, in order. Where the number stays, the picture stays.
class FrameDamage {
 public:
  /// Rectangles that do not overlap; none when nothing changed, the whole window on the first call and for another size.
  std::vector<ScreenRect> update(const ImDrawData& data, int width, int height, LiveTextures live);
  void forget() { squares_.clear(); }

 private:
  void mix_in(const ImDrawList& list, const ImDrawCmd& command, LiveTextures live);
  void mix_into_squares(const ScreenRect& rect, std::uint64_t number);
  std::vector<ScreenRect> rects_of(const std::vector<std::uint64_t>& before) const;

  int width_ = 0, height_ = 0, columns_ = 0, rows_ = 0;
  std::vector<std::uint64_t> squares_;
};

}  // namespace stemwise
