#include "app/window/drawn_shape.hpp"

#include <utility>

namespace stemwise {
namespace {

constexpr double on_corner_px = 9.0;

}  // namespace

void DrawnShape::click(const render::Viewport& viewport, double x_px, double y_px) {
  const Eigen::Vector2d at_px(x_px, y_px);
  const auto is_at = [&](const Eigen::Vector3d& corner_m) { return (viewport.pixels_of(corner_m) - at_px).norm() < on_corner_px; };
  if (corners_m_.size() >= 3 && (is_at(corners_m_.front()) || is_at(corners_m_.back()))) return close();  // the second click of a double one
  if (!corners_m_.empty() && is_at(corners_m_.back())) return;
  if (const auto world = viewport.world_at(x_px, y_px)) corners_m_.push_back(world->position_m);
}

void DrawnShape::forget() {
  corners_m_.clear();
  closed_ = false;
}

std::optional<std::vector<Eigen::Vector3d>> DrawnShape::take() {
  if (!closed_) return std::nullopt;
  closed_ = false;
  return std::exchange(corners_m_, {});
}

std::vector<ui::OverlayLine> DrawnShape::sides(const render::Viewport& viewport, const std::optional<Eigen::Vector2d>& cursor_px) const {
  std::vector<Eigen::Vector2d> at;
  for (const Eigen::Vector3d& corner_m : corners_m_) at.push_back(viewport.pixels_of(corner_m));
  if (cursor_px) at.push_back(*cursor_px);
  std::vector<ui::OverlayLine> lines;
  if (corners_m_.empty() || at.size() < 2) return lines;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Eigen::Vector2d& to = at[(i + 1) % at.size()];
    lines.push_back({at[i].x(), at[i].y(), to.x(), to.y()});
  }
  return lines;
}

}  // namespace stemwise
