#include "render/scene/stem_layer.hpp"

#include <Eigen/Geometry>
#include <vector>

namespace stemwise::render {
namespace {

struct Vertex {
  float base[3], up[3];
  float radius_m;
  Rgba colour;
};

constexpr const char* vertex_source = R"(#version 150
in vec3 base;
in vec3 up;         // axis times height
in float radius_m;
in vec4 colour;
uniform mat4 clip_from_world;
uniform vec3 eye, forward;
uniform float focal_px, least_px, thicker, is_top;
flat out vec3 stem_colour;
out vec2 at;        // across -1..1 and along 0..1; on a cut face both -1..1
out float depth_m;
void main() {
  int corner = gl_VertexID & 3;
  float across = (corner == 1 || corner == 2) ? 1.0 : -1.0;
  bool is_high = corner >= 2;
  vec3 place = base + (is_high || is_top > 0.5 ? up : vec3(0.0));
  depth_m = max(dot(place - eye, forward), 0.01);
  float radius = max(radius_m * thicker, least_px * depth_m / focal_px);
  vec3 axis = normalize(up);
  vec3 side = cross(axis, place - eye);
  side = length(side) > 1e-5 ? normalize(side) : vec3(1.0, 0.0, 0.0);
  if (is_top > 0.5) {
    at = vec2(across, is_high ? 1.0 : -1.0);
    place += (side * at.x + cross(axis, side) * at.y) * radius;
  } else {
    at = vec2(across, is_high ? 1.0 : 0.0);
    place += side * across * radius;
  }
  stem_colour = colour.rgb;
  gl_Position = clip_from_world * vec4(place, 1.0);
})";

constexpr const char* fragment_source = R"(#version 150
flat in vec3 stem_colour;
in vec2 at;
in float depth_m;
uniform float is_top;
uniform vec3 fog_colour;
uniform vec2 fog;   // start, end in metres
out vec4 colour_out;
void main() {
  float light;
  if (is_top > 0.5) {
    float r = dot(at, at);
    if (r > 1.0) discard;
    light = r > 0.72 ? 0.85 : 1.18;
  } else {
    float toward = sqrt(max(0.0, 1.0 - at.x * at.x));
    light = (0.66 + 0.46 * clamp(0.88 * toward + 0.46 * at.x, 0.0, 1.0)) * mix(0.8, 1.0, smoothstep(0.0, 0.1, at.y));
  }
  vec3 shaded = min(stem_colour * light, vec3(1.0));
  colour_out = vec4(mix(shaded, fog_colour, clamp((depth_m - fog.x) / (fog.y - fog.x), 0.0, 1.0) * 0.75), 1.0);
})";

}  // namespace

StemLayer::StemLayer()
    : program_(vertex_source, fragment_source, {"base", "up", "radius_m", "colour"}),
      sides_(sizeof(Vertex), {{3, GL_FLOAT, GL_FALSE, offsetof(Vertex, base)},
                              {3, GL_FLOAT, GL_FALSE, offsetof(Vertex, up)},
                              {1, GL_FLOAT, GL_FALSE, offsetof(Vertex, radius_m)},
                              {4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Vertex, colour)}}),
      tops_(sizeof(Vertex), {{3, GL_FLOAT, GL_FALSE, offsetof(Vertex, base)},
                             {3, GL_FLOAT, GL_FALSE, offsetof(Vertex, up)},
                             {1, GL_FLOAT, GL_FALSE, offsetof(Vertex, radius_m)},
                             {4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Vertex, colour)}}) {}

void StemLayer::fill(std::span<const Mark> marks) {
  std::vector<Vertex> vertices;
  vertices.reserve(4 * marks.size());
  for (const Mark& mark : marks) {
    Vertex vertex{};
    const Eigen::Vector3d up = mark.axis * mark.height_m;
    for (int i = 0; i < 3; ++i) {
      vertex.base[i] = static_cast<float>(mark.base_m[i]);
      vertex.up[i] = static_cast<float>(up[i]);
    }
    vertex.radius_m = static_cast<float>(0.5 * mark.dbh_m);
    vertex.colour = mark.style.colour;
    vertices.insert(vertices.end(), 4, vertex);
  }
  sides_.upload(vertices.data(), marks.size());
  tops_.upload(vertices.data(), marks.size());
}

void StemLayer::set_uniforms(const FrameView& view) const {
  glUniform1f(program_.at("thicker"), static_cast<float>(view.dbh_exaggeration));
  const Rgba fog = theme_colours(view.theme).map;
  glUniformMatrix4fv(program_.at("clip_from_world"), 1, GL_FALSE, view.clip_from_world.data());
  glUniform3fv(program_.at("eye"), 1, view.eye_m.data());
  glUniform3fv(program_.at("forward"), 1, view.forward.data());
  glUniform1f(program_.at("focal_px"), static_cast<float>(view.focal_px));
  glUniform1f(program_.at("least_px"), static_cast<float>(0.6 * view.px_scale));
  glUniform3f(program_.at("fog_colour"), fog.r / 255.0F, fog.g / 255.0F, fog.b / 255.0F);
  glUniform2f(program_.at("fog"), static_cast<float>(view.fog_start_m), static_cast<float>(view.fog_end_m));
}

void StemLayer::draw(const FrameView& view) {
  if (sides_.size() == 0) return;
  program_.use();
  set_uniforms(view);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glUniform1f(program_.at("is_top"), 0.0F);
  sides_.draw();
  if (view.is_moving) return;
  glUniform1f(program_.at("is_top"), 1.0F);
  tops_.draw();
}

}  // namespace stemwise::render
