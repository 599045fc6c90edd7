#pragma once
#include <GL/glew.h>

#include <vector>

#include "render/gl/program.hpp"
#include "render/picture.hpp"

namespace stemwise::render {

/// Puts the drawn scene (any resolution, stretched) and the painted overlay (1:1) together into one texture of the
/// picture's size, bottom row first. The overlay is mostly empty: only its painted tiles are uploaded and blended.
class Compositor {
 public:
  Compositor();
  ~Compositor();
  Compositor(const Compositor&) = delete;
  Compositor& operator=(const Compositor&) = delete;

  /// Takes what is painted on cairo's words (0xAARRGGBB, colours times alpha, top row first) and wipes them for the next time.
  void take_overlay(std::uint32_t* words, int stride_words, PixelSize size);
  GLuint compose(GLuint scene_texture, PixelSize scene_size, PixelSize size);
  GLuint texture() const { return texture_; }
  Image read() const;

 private:
  struct Tile {
    int x = 0, y = 0, width = 0, height = 0;  ///< y from the top
  };
  void make_target(PixelSize size);
  void copy_scene(GLuint texture, PixelSize scene_size) const;
  void blend_overlay() const;

  Program program_;
  GLuint vertex_array_ = 0, framebuffer_ = 0, scene_framebuffer_ = 0, texture_ = 0, overlay_ = 0;
  PixelSize size_, overlay_size_;
  std::vector<Tile> tiles_;
};

}  // namespace stemwise::render
