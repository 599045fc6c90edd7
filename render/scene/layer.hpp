#pragma once
#include <Eigen/Core>
#include <cstddef>

#include "render/palette.hpp"
#include "render/picture.hpp"

namespace stemwise::render {

/// What a layer must know to draw one frame.
struct FrameView {
  Eigen::Matrix4f clip_from_world = Eigen::Matrix4f::Identity();
  PixelSize size;               ///< of the target being drawn into (half of the picture while moving)
  double px_scale = 1.0;        ///< target pixels per 100 % interface pixel
  Eigen::Vector3f eye_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f forward = Eigen::Vector3f::UnitY();
  double focal_px = 1.0;        ///< 3D: pixels of one metre at one metre
  double px_per_m = 1.0;        ///< map
  double dbh_exaggeration = 1.0;  ///< marks are drawn this many times as thick as they are
  double fill_alpha = 0.34;       ///< of the map's circles
  double backing = 0.0;           ///< how much of the map's paper lies under the circles: on a heat map or an image they keep their colours
  double fog_start_m = 1e9, fog_end_m = 2e9;
  bool is_moving = false;
  bool is_map = true;
  std::size_t most_points = 1'000'000;  ///< of one cloud
  Theme theme = Theme::light;
};

/// One kind of data on the graphics card. Made, filled, drawn and destroyed with the context current; draws on top of what
/// is there, leaves depth test and blending as it found them.
class Layer {
 public:
  Layer() = default;
  virtual ~Layer() = default;
  Layer(const Layer&) = delete;
  Layer& operator=(const Layer&) = delete;
  virtual void draw(const FrameView& view) = 0;
};

}  // namespace stemwise::render
