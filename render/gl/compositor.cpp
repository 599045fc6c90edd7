#include "render/gl/compositor.hpp"

#include <algorithm>

namespace stemwise::render {
namespace {

constexpr const char* vertex_source = R"(#version 150
uniform float is_overlay;
out vec2 at;
void main() {
  vec2 unit = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  at = is_overlay > 0.5 ? vec2(unit.x, 1.0 - unit.y) : unit;
  gl_Position = vec4(2.0 * unit - 1.0, 0.0, 1.0);
})";

constexpr const char* fragment_source = R"(#version 150
in vec2 at;
uniform sampler2D picture;
uniform float is_overlay;
out vec4 colour_out;
void main() {
  vec4 colour = texture(picture, at);
  colour_out = is_overlay > 0.5 ? colour : vec4(colour.rgb, 1.0);
})";

constexpr int tile_px = 96;

void set_sampling(GLint filter) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

bool is_empty(const std::uint32_t* first, int stride_words, int width, int height) {
  std::uint32_t any = 0;
  for (int row = 0; row < height; ++row)
    for (int x = 0; x < width; ++x) any |= first[static_cast<std::ptrdiff_t>(stride_words) * row + x];
  return any == 0;
}

}  // namespace

Compositor::Compositor() : program_(vertex_source, fragment_source, {}) {
  glGenVertexArrays(1, &vertex_array_);
  glGenFramebuffers(1, &framebuffer_);
  glGenFramebuffers(1, &scene_framebuffer_);
  glGenTextures(1, &texture_);
  glGenTextures(1, &overlay_);
}

Compositor::~Compositor() {
  glDeleteTextures(1, &overlay_);
  glDeleteTextures(1, &texture_);
  glDeleteFramebuffers(1, &scene_framebuffer_);
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteVertexArrays(1, &vertex_array_);
}

void Compositor::make_target(PixelSize size) {
  if (size == size_) return;
  size_ = size;
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  set_sampling(GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
}

void Compositor::take_overlay(std::uint32_t* words, int stride_words, PixelSize size) {
  glBindTexture(GL_TEXTURE_2D, overlay_);
  if (size != overlay_size_) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, nullptr);
    set_sampling(GL_NEAREST);
  }
  overlay_size_ = size;
  tiles_.clear();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, stride_words);
  for (int y = 0; y < size.height; y += tile_px)
    for (int x = 0; x < size.width; x += tile_px) {
      const Tile tile{x, y, std::min(tile_px, size.width - x), std::min(tile_px, size.height - y)};
      std::uint32_t* first = words + static_cast<std::ptrdiff_t>(stride_words) * y + x;
      if (is_empty(first, stride_words, tile.width, tile.height)) continue;
      glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, tile.width, tile.height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, first);
      for (int row = 0; row < tile.height; ++row) std::fill_n(first + static_cast<std::ptrdiff_t>(stride_words) * row, tile.width, 0U);
      tiles_.push_back(tile);
    }
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void Compositor::copy_scene(GLuint texture, PixelSize scene_size) const {
  if (scene_size == size_) {  // a plain copy, much cheaper than sampling where the processor draws
    glBindFramebuffer(GL_READ_FRAMEBUFFER, scene_framebuffer_);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    return;
  }
  glBindTexture(GL_TEXTURE_2D, texture);
  set_sampling(GL_LINEAR);
  glUniform1f(program_.at("is_overlay"), 0.0F);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Compositor::blend_overlay() const {
  if (overlay_size_ != size_) return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindTexture(GL_TEXTURE_2D, overlay_);
  glUniform1f(program_.at("is_overlay"), 1.0F);
  glEnable(GL_SCISSOR_TEST);
  for (const Tile& tile : tiles_) {
    glScissor(tile.x, size_.height - tile.y - tile.height, tile.width, tile.height);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glDisable(GL_SCISSOR_TEST);
}

GLuint Compositor::compose(GLuint scene_texture, PixelSize scene_size, PixelSize size) {
  make_target(size);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, size.width, size.height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  program_.use();
  glActiveTexture(GL_TEXTURE0);
  glUniform1i(program_.at("picture"), 0);
  glBindVertexArray(vertex_array_);
  copy_scene(scene_texture, scene_size);
  blend_overlay();
  glBindVertexArray(0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glUseProgram(0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return texture_;
}

Image Compositor::read() const {
  Image image{size_, std::vector<std::uint8_t>(static_cast<std::size_t>(4) * size_.width * size_.height)};
  if (size_.width == 0) return image;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(4) * size_.width;
  for (int low = 0, high = size_.height - 1; low < high; ++low, --high)
    std::swap_ranges(image.rgba.begin() + stride * low, image.rgba.begin() + stride * (low + 1), image.rgba.begin() + stride * high);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

}  // namespace stemwise::render
