#include "render/scene/cloud_layer.hpp"

#include <algorithm>
#include <cmath>

#include "render/palette.hpp"

namespace stemwise::render {
namespace {

struct Vertex {
  float x, y, z;
  Rgba colour;
};

constexpr double points_per_sq_px = 0.8;
constexpr float height_of_brightest_m = 28.0F;

constexpr const char* vertex_source = R"(#version 150
in vec3 place;
in vec4 colour;
uniform mat4 clip_from_world;
uniform vec3 eye, forward;
uniform float spacing_px, least_px, most_px, is_map;   // spacing_px: at one metre, on the map everywhere
flat out vec3 point_colour;
flat out float depth_m;
void main() {
  point_colour = colour.rgb;
  depth_m = 0.0;
  if (is_map > 0.5) {
    gl_PointSize = clamp(spacing_px, least_px, most_px);
    // Under the marks, and what is higher over what is lower.
    gl_Position = clip_from_world * vec4(place.xy, -4.4 + 0.3 * clamp(place.z / 400.0 + 0.5, 0.0, 1.0), 1.0);
  } else {
    depth_m = max(dot(place - eye, forward), 0.01);
    gl_PointSize = clamp(spacing_px / depth_m, least_px, most_px);
    gl_Position = clip_from_world * vec4(place, 1.0);
  }
})";

constexpr const char* fragment_source = R"(#version 150
flat in vec3 point_colour;
flat in float depth_m;
uniform float opacity;
uniform vec3 fog_colour;
uniform vec2 fog;   // start, end in metres
out vec4 colour_out;
void main() {
  vec3 shaded = mix(point_colour, fog_colour, clamp((depth_m - fog.x) / (fog.y - fog.x), 0.0, 1.0) * 0.75);
  colour_out = vec4(shaded * opacity, opacity);
})";

Rgba grey(float value) {
  const auto byte = static_cast<std::uint8_t>(std::clamp(value, 0.0F, 255.0F));
  return {byte, byte, byte, 255};
}

/// Greys that stand out from the theme's paper.
struct GreyRange {
  float darkest, brightest;
};
GreyRange range_of(Theme theme) { return theme == Theme::dark ? GreyRange{92.0F, 240.0F} : GreyRange{44.0F, 176.0F}; }

Rgba colour_of(const CloudPoint& p, CloudShade shade, const GreyRange& range) {
  switch (shade) {
    case CloudShade::colour: return {p.red, p.green, p.blue, 255};
    case CloudShade::intensity: return grey(range.darkest + (range.brightest - range.darkest) / 255.0F * p.intensity);
    case CloudShade::height: break;
  }
  return grey(std::clamp(range.darkest + (range.brightest - range.darkest) / height_of_brightest_m * p.above_ground_m, range.darkest, range.brightest));
}

}  // namespace

CloudLayer::CloudLayer() : program_(vertex_source, fragment_source, {"place", "colour"}) {
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
}

CloudLayer::~CloudLayer() {
  glDeleteBuffers(1, &vertices_);
  glDeleteVertexArrays(1, &array_);
}

void CloudLayer::fill(const CloudUnderlay& cloud, const ShownUnderlay& shown, const CloudPlace& place) {
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  const auto bytes = static_cast<GLsizeiptr>(std::max<std::size_t>(1, cloud.points.size()) * sizeof(Vertex));
  glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STATIC_DRAW);
  // A million points in a few milliseconds: straight into the buffer.
  auto* const vertices = static_cast<Vertex*>(glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT));
  std::size_t next = 0;
  const GreyRange range = range_of(place.theme);
  tiles_.clear();
  spacing_m_ = cloud.spacing_m;
  const Eigen::Vector3f shift = (cloud.origin_in_reference_m - place.origin_m + Eigen::Vector3d(0.0, 0.0, place.shift_m)).cast<float>();
  const auto low = static_cast<float>(shown.low_m), high = static_cast<float>(shown.high_m);
  for (const CloudTile& of : cloud.tiles) {
    if (!vertices) break;
    Tile tile{static_cast<GLint>(next), 0, Eigen::Vector3f::Constant(1e30F), Eigen::Vector3f::Constant(-1e30F)};
    for (std::size_t i = of.first; i < of.first + of.count; ++i) {
      const CloudPoint& p = cloud.points[i];
      if (p.above_ground_m < low || p.above_ground_m > high) continue;
      const Eigen::Vector3f at(p.x_m + shift.x(), p.y_m + shift.y(), place.is_flat ? p.above_ground_m : p.z_m + shift.z());
      tile.low_m = tile.low_m.cwiseMin(at);
      tile.high_m = tile.high_m.cwiseMax(at);
      vertices[next++] = {at.x(), at.y(), at.z(), colour_of(p, shown.shade, range)};
    }
    tile.count = next - static_cast<std::size_t>(tile.first);
    if (tile.count > 0) tiles_.push_back(tile);
  }
  if (vertices) glUnmapBuffer(GL_ARRAY_BUFFER);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex), reinterpret_cast<const void*>(offsetof(Vertex, colour)));
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

std::size_t CloudLayer::wanted(const Tile& tile, const FrameView& view) const {
  int outside[4] = {0, 0, 0, 0}, behind = 0;  // of the eight corners
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector4f world((corner & 1 ? tile.high_m : tile.low_m).x(), (corner & 2 ? tile.high_m : tile.low_m).y(), view.is_map ? 0.0F : (corner & 4 ? tile.high_m : tile.low_m).z(), 1.0F);
    const Eigen::Vector4f clip = view.clip_from_world * world;
    behind += clip.w() <= 0.0F;
    outside[0] += clip.x() < -clip.w();
    outside[1] += clip.x() > clip.w();
    outside[2] += clip.y() < -clip.w();
    outside[3] += clip.y() > clip.w();
  }
  if (behind == 8 || std::any_of(outside, outside + 4, [](int count) { return count == 8; })) return 0;
  const Eigen::Vector3f size_m = tile.high_m - tile.low_m;
  double px_per_m = view.px_per_m, area_sq_m = static_cast<double>(size_m.x()) * size_m.y();
  if (!view.is_map) {
    const float nearest_m = std::max(1.0F, (0.5F * (tile.low_m + tile.high_m) - view.eye_m).dot(view.forward) - 0.5F * size_m.norm());
    px_per_m = view.focal_px / nearest_m;
    area_sq_m += static_cast<double>(size_m.z()) * std::max(size_m.x(), size_m.y());
  }
  return static_cast<std::size_t>(std::min(static_cast<double>(tile.count), 1.0 + points_per_sq_px * area_sq_m * px_per_m * px_per_m));
}

void CloudLayer::choose(const FrameView& view) {
  std::size_t all = 0;
  firsts_.clear();
  counts_.clear();
  for (const Tile& tile : tiles_) {
    const std::size_t count = wanted(tile, view);
    if (count == 0) continue;
    firsts_.push_back(tile.first);
    counts_.push_back(static_cast<GLsizei>(count));
    all += count;
  }
  const double share = all > view.most_points ? static_cast<double>(view.most_points) / static_cast<double>(all) : 1.0;
  points_drawn_ = 0;
  for (GLsizei& count : counts_) {
    count = static_cast<GLsizei>(share * count);
    points_drawn_ += static_cast<std::size_t>(count);
  }
}

void CloudLayer::set_uniforms(const FrameView& view) const {
  const Rgba fog = theme_colours(view.theme).map;
  glUniformMatrix4fv(program_.at("clip_from_world"), 1, GL_FALSE, view.clip_from_world.data());
  glUniform3fv(program_.at("eye"), 1, view.eye_m.data());
  glUniform3fv(program_.at("forward"), 1, view.forward.data());
  glUniform1f(program_.at("is_map"), view.is_map ? 1.0F : 0.0F);
  glUniform1f(program_.at("spacing_px"), static_cast<float>(spacing_m_ * (view.is_map ? view.px_per_m : view.focal_px)));
  glUniform1f(program_.at("least_px"), static_cast<float>(std::max(1.0, (view.is_moving ? 1.6 : 1.0) * view.px_scale)));
  glUniform1f(program_.at("most_px"), static_cast<float>(std::max(1.0, 3.0 * view.px_scale)));
  glUniform1f(program_.at("opacity"), opacity_);
  glUniform3f(program_.at("fog_colour"), fog.r / 255.0F, fog.g / 255.0F, fog.b / 255.0F);
  glUniform2f(program_.at("fog"), static_cast<float>(view.fog_start_m), static_cast<float>(view.fog_end_m));
}

void CloudLayer::draw(const FrameView& view) {
  choose(view);
  if (points_drawn_ == 0) return;
  program_.use();
  set_uniforms(view);
  if (opacity_ < 0.999F) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  } else {
    glDisable(GL_BLEND);
  }
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glBindVertexArray(array_);
  glMultiDrawArrays(GL_POINTS, firsts_.data(), counts_.data(), static_cast<GLsizei>(firsts_.size()));
  glBindVertexArray(0);
  glDisable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace stemwise::render
