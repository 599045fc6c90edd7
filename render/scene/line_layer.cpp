#include "render/scene/line_layer.hpp"

#include <algorithm>
#include <vector>

namespace stemwise::render {
namespace {

struct Vertex {
  float a[3], b[3];
  float along_m;
  Rgba colour;
  std::uint8_t width_16th, dash_px, unused[2];
};

constexpr const char* vertex_source = R"(#version 150
in vec3 a;
in vec3 b;
in float along_m;
in vec4 colour;
in vec2 style;      // width in 1/16 px, dash in px
uniform mat4 clip_from_world;
uniform vec2 size_px;
uniform float px_scale, px_per_m;
flat out vec4 line_colour;
flat out vec2 width_and_dash;
noperspective out vec2 at;
void main() {
  int corner = gl_VertexID & 3;
  vec4 from = clip_from_world * vec4(a, 1.0), to = clip_from_world * vec4(b, 1.0);
  const float nearest = 0.05;
  if (from.w < nearest && to.w > nearest) from = mix(from, to, (nearest - from.w) / (to.w - from.w));
  if (to.w < nearest && from.w > nearest) to = mix(to, from, (nearest - to.w) / (from.w - to.w));
  vec2 along = (to.xy / to.w - from.xy / from.w) * 0.5 * size_px;
  float length_px = length(along);
  vec2 direction = length_px > 1e-4 ? along / length_px : vec2(1.0, 0.0);
  float width = max(style.x / 16.0 * px_scale, 0.75);
  bool is_end = corner == 1 || corner == 2;
  float side = corner >= 2 ? 1.0 : -1.0;
  float reach = 0.5 * width + 1.0;
  vec2 offset = vec2(-direction.y, direction.x) * side * reach + direction * (is_end ? 0.5 : -0.5) * width;
  gl_Position = is_end ? to : from;
  gl_Position.xy += 2.0 * offset / size_px * gl_Position.w;
  at = vec2((is_end ? length_px : 0.0) + along_m * px_per_m, side * reach);
  line_colour = colour;
  width_and_dash = vec2(width, style.y * px_scale);
})";

constexpr const char* fragment_source = R"(#version 150
flat in vec4 line_colour;
flat in vec2 width_and_dash;
noperspective in vec2 at;
out vec4 colour_out;
void main() {
  float alpha = clamp(0.5 * width_and_dash.x + 0.5 - abs(at.y), 0.0, 1.0) * line_colour.a;
  float dash = width_and_dash.y;
  if (dash > 0.0) alpha *= clamp(0.5 * dash + 0.5 - abs(mod(at.x, 2.0 * dash) - 0.5 * dash), 0.0, 1.0);
  if (alpha < 0.004) discard;
  colour_out = vec4(line_colour.rgb * alpha, alpha);
})";

}  // namespace

LineLayer::LineLayer(bool uses_depth)
    : program_(vertex_source, fragment_source, {"a", "b", "along_m", "colour", "style"}),
      quads_(sizeof(Vertex), {{3, GL_FLOAT, GL_FALSE, offsetof(Vertex, a)},
                              {3, GL_FLOAT, GL_FALSE, offsetof(Vertex, b)},
                              {1, GL_FLOAT, GL_FALSE, offsetof(Vertex, along_m)},
                              {4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Vertex, colour)},
                              {2, GL_UNSIGNED_BYTE, GL_FALSE, offsetof(Vertex, width_16th)}}),
      uses_depth_(uses_depth) {}

void LineLayer::fill(std::span<const LineSegment> segments) {
  std::vector<Vertex> vertices;
  vertices.reserve(4 * segments.size());
  for (const LineSegment& s : segments) {
    Vertex vertex{};
    for (int i = 0; i < 3; ++i) {
      vertex.a[i] = static_cast<float>(s.a_m[i]);
      vertex.b[i] = static_cast<float>(s.b_m[i]);
    }
    vertex.along_m = static_cast<float>(s.along_m);
    vertex.colour = s.colour;
    vertex.width_16th = static_cast<std::uint8_t>(std::clamp(s.width_px * 16.0, 1.0, 255.0));
    vertex.dash_px = static_cast<std::uint8_t>(std::clamp(s.dash_px, 0.0, 255.0));
    vertices.insert(vertices.end(), 4, vertex);
  }
  quads_.upload(vertices.data(), segments.size());
}

void LineLayer::draw(const FrameView& view) {
  if (quads_.size() == 0) return;
  program_.use();
  glUniformMatrix4fv(program_.at("clip_from_world"), 1, GL_FALSE, view.clip_from_world.data());
  glUniform2f(program_.at("size_px"), static_cast<float>(view.size.width), static_cast<float>(view.size.height));
  glUniform1f(program_.at("px_scale"), static_cast<float>(view.px_scale));
  glUniform1f(program_.at("px_per_m"), static_cast<float>(view.px_per_m));
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (uses_depth_) {
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
  } else {
    glDisable(GL_DEPTH_TEST);
  }
  quads_.draw();
  glDepthMask(GL_TRUE);
}

}  // namespace stemwise::render
