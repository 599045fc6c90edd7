#pragma once
#include <vector>

#include "core/underlay/cloud_underlay.hpp"
#include "render/gl/program.hpp"
#include "render/scene/layer.hpp"
#include "render/view_options.hpp"

namespace stemwise::render {

/// How a cloud lies in the scene.
struct CloudPlace {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< of the scene
  double shift_m = 0.0;         ///< added to the heights, so that the cloud stands on the stems' ground
  Theme theme = Theme::light;
  bool is_flat = false;         ///< the stems have no heights: the cloud stands on a plane
};

/// The points of a cloud. Of every tile as many are drawn as can be told apart at its distance, and of all not more than
/// the frame allows.
class CloudLayer : public Layer {
 public:
  CloudLayer();
  ~CloudLayer() override;
  void fill(const CloudUnderlay& cloud, const ShownUnderlay& shown, const CloudPlace& place);
  void set_opacity(double opacity) { opacity_ = static_cast<float>(opacity); }
  void draw(const FrameView& view) override;
  std::size_t points_drawn() const { return points_drawn_; }  ///< last time

 private:
  struct Tile {
    GLint first = 0;
    std::size_t count = 0;
    Eigen::Vector3f low_m, high_m;
  };
  /// Points that can be told apart in the tile's part of the picture; 0 outside of it.
  std::size_t wanted(const Tile& tile, const FrameView& view) const;
  void choose(const FrameView& view);
  void set_uniforms(const FrameView& view) const;

  Program program_;
  GLuint array_ = 0, vertices_ = 0;
  std::vector<Tile> tiles_;
  std::vector<GLint> firsts_;
  std::vector<GLsizei> counts_;
  std::size_t points_drawn_ = 0;
  double spacing_m_ = 0.1;
  float opacity_ = 1.0F;
};

}  // namespace stemwise::render
