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

void set_sampling() {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

Compositor::Compositor() : program_(vertex_source, fragment_source, {}) {
  glGenVertexArrays(1, &vertex_array_);
  glGenFramebuffers(1, &framebuffer_);
  glGenTextures(1, &texture_);
  glGenTextures(1, &overlay_);
}

Compositor::~Compositor() {
  glDeleteTextures(1, &overlay_);
  glDeleteTextures(1, &texture_);
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteVertexArrays(1, &vertex_array_);
}

void Compositor::make_target(PixelSize size) {
  if (size == size_) return;
  size_ = size;
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  set_sampling();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
}

void Compositor::set_overlay(const Image& overlay) {
  glBindTexture(GL_TEXTURE_2D, overlay_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (overlay.size == overlay_size_) {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, overlay.size.width, overlay.size.height, GL_RGBA, GL_UNSIGNED_BYTE, overlay.rgba.data());
  } else {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, overlay.size.width, overlay.size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, overlay.rgba.data());
    set_sampling();
  }
  overlay_size_ = overlay.size;
  glBindTexture(GL_TEXTURE_2D, 0);
}

void Compositor::draw(GLuint texture, bool is_overlay) const {
  glBindTexture(GL_TEXTURE_2D, texture);
  glUniform1f(program_.at("is_overlay"), is_overlay ? 1.0F : 0.0F);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

GLuint Compositor::compose(GLuint scene_texture, PixelSize size) {
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
  draw(scene_texture, false);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (overlay_size_ == size) draw(overlay_, true);
  glBindVertexArray(0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glUseProgram(0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return texture_;
}

Image Compositor::read() const {
  Image image{size_, std::vector<std::uint8_t>(static_cast<std::size_t>(4) * size_.width * size_.height)};
  if (size_.width == 0) return image;
  std::vector<std::uint8_t> rows(image.rgba.size());
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  const std::size_t stride = static_cast<std::size_t>(4) * size_.width;
  for (int y = 0; y < size_.height; ++y)
    std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(stride * (size_.height - 1 - y)), stride,
                image.rgba.begin() + static_cast<std::ptrdiff_t>(stride * y));
  return image;
}

}  // namespace stemwise::render
