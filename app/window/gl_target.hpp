#pragma once
#include <cstdint>

#include "render/picture.hpp"

namespace stemwise {

/// A colour buffer to draw into where there is no window. Needs a current GL context for its whole life.
class GlTarget {
 public:
  GlTarget(int width, int height);
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;
  void bind() const;
  void bind_to_read() const;
  render::Image read() const;  ///< top row first

 private:
  std::uint32_t framebuffer_ = 0;
  std::uint32_t texture_ = 0;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace stemwise
