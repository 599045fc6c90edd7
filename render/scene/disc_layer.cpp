#include "render/scene/disc_layer.hpp"

#include <algorithm>
#include <vector>

#include "render/palette.hpp"
#include "render/projection.hpp"

namespace stemwise::render {
namespace {

struct Vertex {
  float x, y, dbh_m;
  Rgba colour;
  std::uint8_t shape, unused[3];
};

constexpr const char* vertex_source = R"(#version 150
in vec3 place;      // x, y, DBH in metres
in vec4 colour;
in float shape;
uniform mat4 clip_from_world;
uniform vec2 size_px;
uniform float px_per_dbh_m, least_px, px_scale;
flat out vec4 mark_colour;
flat out float mark_shape, radius;
out vec2 at;
void main() {
  int corner = gl_VertexID & 3;
  vec2 unit = vec2((corner == 1 || corner == 2) ? 1.0 : -1.0, corner >= 2 ? 1.0 : -1.0);
  radius = max(0.5 * place.z * px_per_dbh_m, least_px);
  float reach = (shape == 3.0 || shape == 6.0 ? 1.42 * radius : radius) + 1.5 * px_scale;
  at = unit * reach;
  mark_colour = colour;
  mark_shape = shape;
  gl_Position = clip_from_world * vec4(place.xy, 0.0, 1.0);
  gl_Position.xy += 2.0 * at / size_px;
})";

// Distances in pixels; shape numbers are those of MarkShape.
constexpr const char* fragment_source = R"(#version 150
flat in vec4 mark_colour;
flat in float mark_shape, radius;
in vec2 at;
uniform float px_scale, fill_alpha, backing;
uniform vec3 paper;
out vec4 colour_out;
float line(float distance_px, float width_px) { return clamp(0.5 * width_px + 0.5 - abs(distance_px), 0.0, 1.0); }
void main() {
  int shape = int(mark_shape + 0.5);
  float width = px_scale * clamp(radius * 0.28, 0.9, 1.5);
  float around = length(at) - radius;
  if (shape == 5) around = (abs(at.x) + abs(at.y)) * 0.7071 - 0.85 * radius;
  if (shape == 7) around = max(abs(at.x), abs(at.y)) - 0.82 * radius;
  float inside = clamp(0.5 - around, 0.0, 1.0);
  float outline = line(around + 0.5 * width, width);
  float fill = shape == 4 ? 0.25 * fill_alpha : shape == 6 ? min(0.7, 2.0 * fill_alpha) : fill_alpha;
  fill = mix(shape == 4 ? 0.35 : 0.95, fill, clamp((radius / px_scale - 1.5) / 2.0, 0.0, 1.0));
  if (shape == 3 || shape == 6 || shape == 7) {
    vec2 turned = vec2(at.x - at.y, at.x + at.y) * 0.7071;
    float reach = shape == 7 ? radius : 1.4 * radius;
    float arms = max(line(turned.x, width), line(turned.y, width)) * clamp(reach - length(at) + 0.5, 0.0, 1.0);
    outline = max(outline, arms);
  } else if (shape == 1) {
    float arms = max(line(at.x, width), line(at.y, width)) * clamp(0.5 * radius - max(abs(at.x), abs(at.y)) + 0.5, 0.0, 1.0);
    if (radius > 4.0 * px_scale) outline = max(outline, arms);
  } else if (shape == 2) {
    if (radius > 3.5 * px_scale) outline = max(outline, line(length(at) - 0.45 * radius, width));
  }
  float alpha = max(inside * fill, outline) * mark_colour.a;
  float under = backing * clamp(px_scale + 0.5 - around, 0.0, 1.0) * mark_colour.a * (1.0 - alpha);
  if (alpha + under < 0.004) discard;
  colour_out = vec4(mark_colour.rgb * alpha + paper * under, alpha + under);
})";

}  // namespace

DiscLayer::DiscLayer()
    : program_(vertex_source, fragment_source, {"place", "colour", "shape"}),
      quads_(sizeof(Vertex), {{3, GL_FLOAT, GL_FALSE, offsetof(Vertex, x)},
                              {4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Vertex, colour)},
                              {1, GL_UNSIGNED_BYTE, GL_FALSE, offsetof(Vertex, shape)}}) {}

void DiscLayer::fill(std::span<const Mark> marks) {
  std::vector<const Mark*> order;  // thick ones first: a small circle is never hidden under a large one
  order.reserve(marks.size());
  for (const Mark& mark : marks) order.push_back(&mark);
  std::stable_sort(order.begin(), order.end(), [](const Mark* a, const Mark* b) { return a->dbh_m > b->dbh_m; });
  std::vector<Vertex> vertices;
  vertices.reserve(4 * order.size());
  for (const Mark* mark : order) {
    const Vertex vertex{static_cast<float>(mark->base_m.x()), static_cast<float>(mark->base_m.y()), static_cast<float>(mark->dbh_m),
                        mark->style.colour, static_cast<std::uint8_t>(mark->style.shape), {}};
    vertices.insert(vertices.end(), 4, vertex);
  }
  quads_.upload(vertices.data(), order.size());
}

void DiscLayer::draw(const FrameView& view) {
  if (quads_.size() == 0) return;
  program_.use();
  glUniformMatrix4fv(program_.at("clip_from_world"), 1, GL_FALSE, view.clip_from_world.data());
  glUniform2f(program_.at("size_px"), static_cast<float>(view.size.width), static_cast<float>(view.size.height));
  glUniform1f(program_.at("px_per_dbh_m"), static_cast<float>(view.px_per_m * view.dbh_exaggeration));
  glUniform1f(program_.at("least_px"), static_cast<float>(least_disc_radius_px * view.px_scale));
  glUniform1f(program_.at("px_scale"), static_cast<float>(view.px_scale));
  glUniform1f(program_.at("fill_alpha"), static_cast<float>(view.fill_alpha));
  glUniform1f(program_.at("backing"), static_cast<float>(view.backing));
  const Rgba paper = theme_colours(view.theme).map;
  glUniform3f(program_.at("paper"), paper.r / 255.0F, paper.g / 255.0F, paper.b / 255.0F);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_DEPTH_TEST);
  quads_.draw();
}

}  // namespace stemwise::render
