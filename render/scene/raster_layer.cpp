#include "render/scene/raster_layer.hpp"

#include <algorithm>

namespace stemwise::render {
namespace {

struct Vertex {
  float x, y, z, u, v;
};

constexpr float map_depth_m = -4.5F;  // above the coverage, under the heat map
constexpr double above_ground_m = 0.03;
constexpr int draped_cells = 96;      // a side: enough for the ground's own 90

constexpr const char* vertex_source = R"(#version 150
in vec3 place;
in vec2 texel;
uniform mat4 clip_from_world;
out vec2 at;
void main() {
  at = texel;
  gl_Position = clip_from_world * vec4(place, 1.0);
})";

constexpr const char* fragment_source = R"(#version 150
in vec2 at;
uniform sampler2D picture;
uniform float opacity;
out vec4 colour_out;
void main() {
  vec4 colour = texture(picture, at);
  float alpha = colour.a * opacity;
  if (alpha < 0.004) discard;
  colour_out = vec4(colour.rgb * alpha, alpha);
})";

/// Where a share of the picture's width and height lies, between the net's nodes.
Eigen::Vector2d place_of(const RasterUnderlay& raster, double u, double v) {
  const double x = u * (raster.columns - 1), y = v * (raster.rows - 1);
  const int column = std::min(static_cast<int>(x), raster.columns - 2), row = std::min(static_cast<int>(y), raster.rows - 2);
  const double a = x - column, b = y - row;
  return (1 - b) * ((1 - a) * raster.node_m(column, row) + a * raster.node_m(column + 1, row)) +
         b * ((1 - a) * raster.node_m(column, row + 1) + a * raster.node_m(column + 1, row + 1));
}

}  // namespace

RasterLayer::RasterLayer(const RasterUnderlay& raster)
    : program_(vertex_source, fragment_source, {"place", "texel"}),
      cells_(sizeof(Vertex), {{3, GL_FLOAT, GL_FALSE, offsetof(Vertex, x)}, {2, GL_FLOAT, GL_FALSE, offsetof(Vertex, u)}}) {
  glGenTextures(1, &texture_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, raster.width_px, raster.height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, raster.rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

RasterLayer::~RasterLayer() { glDeleteTextures(1, &texture_); }

void RasterLayer::place(const RasterUnderlay& raster, const Eigen::Vector3d& origin_m, const Ground* ground) {
  const int columns = ground ? draped_cells : raster.columns - 1, rows = ground ? draped_cells : raster.rows - 1;
  const auto vertex = [&](int column, int row) {
    const double u = static_cast<double>(column) / columns, v = static_cast<double>(row) / rows;
    const Eigen::Vector2d p = place_of(raster, u, v) - origin_m.head<2>();
    const float z = ground ? static_cast<float>(ground->height_at_m(p) + above_ground_m) : map_depth_m;
    return Vertex{static_cast<float>(p.x()), static_cast<float>(p.y()), z, static_cast<float>(u), static_cast<float>(v)};
  };
  std::vector<Vertex> vertices;
  vertices.reserve(static_cast<std::size_t>(4) * columns * rows);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      vertices.insert(vertices.end(), {vertex(column, row + 1), vertex(column + 1, row + 1), vertex(column + 1, row), vertex(column, row)});
  cells_.upload(vertices.data(), static_cast<std::size_t>(columns) * rows);
}

void RasterLayer::draw(const FrameView& view) {
  program_.use();
  glUniformMatrix4fv(program_.at("clip_from_world"), 1, GL_FALSE, view.clip_from_world.data());
  glUniform1f(program_.at("opacity"), opacity_);
  glUniform1i(program_.at("picture"), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  if (!view.is_map) {  // the ground's triangles are not ours: a little nearer to the eye than they
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-2.0F, -2.0F);
  }
  cells_.draw();
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthMask(GL_TRUE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace stemwise::render
