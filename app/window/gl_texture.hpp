#pragma once
#include <cstdint>

namespace stemwise {

/// A picture for the panels, as a GL texture. Needs a current GL context from the first upload to its end.
class GlTexture {
 public:
  GlTexture() = default;
  ~GlTexture();
  GlTexture(const GlTexture&) = delete;
  GlTexture& operator=(const GlTexture&) = delete;

  /// Rows from the top, RGBA with straight alpha.
  void upload(const std::uint8_t* rgba, int width_px, int height_px);
  std::uint64_t id() const { return id_; }  ///< 0 before the first upload
  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

 private:
  std::uint32_t id_ = 0;
  int width_px_ = 0, height_px_ = 0;
};

}  // namespace stemwise
