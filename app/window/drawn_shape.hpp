#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "render/viewport.hpp"
#include "ui/window_status.hpp"

namespace stemwise {

/// A polygon that is drawn by clicks in the viewport: its corners stay on the ground while the view moves.
class DrawnShape {
 public:
  /// A click: one corner more, or the end where it is on the first one.
  void click(const render::Viewport& viewport, double x_px, double y_px);
  void close() { closed_ = corners_m_.size() >= 3; }
  void take_back() { if (!corners_m_.empty()) corners_m_.pop_back(); }
  void forget();
  /// The corners in the reference's frame once it is closed; then it is forgotten.
  std::optional<std::vector<Eigen::Vector3d>> take();
  std::size_t size() const { return corners_m_.size(); }

  /// Its sides in pixels of the picture, by the cursor where there is one.
  std::vector<ui::OverlayLine> sides(const render::Viewport& viewport, const std::optional<Eigen::Vector2d>& cursor_px) const;

 private:
  std::vector<Eigen::Vector3d> corners_m_;
  bool closed_ = false;
};

}  // namespace stemwise
