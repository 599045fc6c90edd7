#pragma once
#include <Eigen/Core>
#include <span>

#include "render/gl/program.hpp"
#include "render/gl/quads.hpp"
#include "render/scene/layer.hpp"

namespace stemwise::render {

struct LineSegment {
  Eigen::Vector3d a_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d b_m = Eigen::Vector3d::Zero();
  Rgba colour;
  double width_px = 1.0;    ///< at 100 %, at most 15
  double dash_px = 0.0;     ///< length of a dash and of a gap; 0: solid
  double along_m = 0.0;     ///< where on its polyline it starts, so that dashes run on
};

/// Smooth straight lines of a width in pixels, in the plane of the picture or in space.
class LineLayer : public Layer {
 public:
  explicit LineLayer(bool uses_depth);
  void fill(std::span<const LineSegment> segments);
  void draw(const FrameView& view) override;

 private:
  Program program_;
  Quads quads_;
  bool uses_depth_;
};

}  // namespace stemwise::render
