#pragma once
#include <GL/glew.h>

#include "render/gl/program.hpp"
#include "render/gl/quads.hpp"
#include "render/picture.hpp"

namespace stemwise::render {

/// Puts the drawn scene (any resolution, stretched) and the painted overlay (1:1, straight alpha, top row first) together
/// into one texture of the picture's size, bottom row first.
class Compositor {
 public:
  Compositor();
  ~Compositor();
  Compositor(const Compositor&) = delete;
  Compositor& operator=(const Compositor&) = delete;

  void set_overlay(const Image& overlay);
  GLuint compose(GLuint scene_texture, PixelSize size);
  GLuint texture() const { return texture_; }
  Image read() const;

 private:
  void make_target(PixelSize size);
  void draw(GLuint texture, bool is_overlay) const;

  Program program_;
  GLuint vertex_array_ = 0, framebuffer_ = 0, texture_ = 0, overlay_ = 0;
  PixelSize size_, overlay_size_;
};

}  // namespace stemwise::render
