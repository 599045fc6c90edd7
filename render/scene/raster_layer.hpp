#pragma once
#include "core/underlay/raster_underlay.hpp"
#include "render/gl/program.hpp"
#include "render/gl/quads.hpp"
#include "render/ground.hpp"
#include "render/scene/layer.hpp"

namespace stemwise::render {

/// A picture under the stems: flat under everything on the map, draped over the ground in 3D.
class RasterLayer : public Layer {
 public:
  explicit RasterLayer(const RasterUnderlay& raster);  ///< takes the pixels to the graphics card
  ~RasterLayer() override;
  /// `ground`: none for the map.
  void place(const RasterUnderlay& raster, const Eigen::Vector3d& origin_m, const Ground* ground);
  void set_opacity(double opacity) { opacity_ = static_cast<float>(opacity); }
  void draw(const FrameView& view) override;

 private:
  Program program_;
  Quads cells_;
  GLuint texture_ = 0;
  float opacity_ = 1.0F;
};

}  // namespace stemwise::render
