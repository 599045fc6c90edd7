#include "render/view_camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stemwise::render {
namespace {

constexpr double least_metres_per_px = 0.0005, most_metres_per_px = 200.0;
constexpr double least_distance_m = 0.5, most_distance_m = 50'000.0;
constexpr double least_elevation_rad = 0.02, most_elevation_rad = 0.5 * std::numbers::pi - 0.001;
constexpr double radians_per_px = 0.006;

Eigen::Vector2d middle(PixelSize size) { return {0.5 * size.width, 0.5 * size.height}; }

}  // namespace

Eigen::Vector2d MapCamera::pixels_of(const Eigen::Vector2d& world_m, PixelSize size) const {
  const Eigen::Vector2d offset = (world_m - centre_m) / metres_per_px;
  return middle(size) + Eigen::Vector2d(offset.x(), -offset.y());
}

Eigen::Vector2d MapCamera::world_at(const Eigen::Vector2d& pixel, PixelSize size) const {
  const Eigen::Vector2d offset = (pixel - middle(size)) * metres_per_px;
  return centre_m + Eigen::Vector2d(offset.x(), -offset.y());
}

void MapCamera::pan(double dx_px, double dy_px) { centre_m += Eigen::Vector2d(-dx_px, dy_px) * metres_per_px; }

void MapCamera::zoom_at(const Eigen::Vector2d& pixel, double factor, PixelSize size) {
  const Eigen::Vector2d fixed_m = world_at(pixel, size);
  metres_per_px = std::clamp(metres_per_px / factor, least_metres_per_px, most_metres_per_px);
  centre_m += fixed_m - world_at(pixel, size);
}

Eigen::Vector3d OrbitCamera::forward() const {
  const double flat = std::cos(elevation_rad);
  return {flat * std::sin(azimuth_rad), flat * std::cos(azimuth_rad), -std::sin(elevation_rad)};
}
Eigen::Vector3d OrbitCamera::right() const { return {std::cos(azimuth_rad), -std::sin(azimuth_rad), 0.0}; }
Eigen::Vector3d OrbitCamera::up() const { return right().cross(forward()); }
Eigen::Vector3d OrbitCamera::eye_m() const { return target_m - distance_m * forward(); }

double OrbitCamera::focal_px(PixelSize size) const { return 0.5 * size.height / std::tan(0.5 * field_of_view_rad); }

std::optional<Eigen::Vector3d> OrbitBasis::pixels_of(const Eigen::Vector3d& world_m) const {
  const Eigen::Vector3d offset = world_m - eye_m;
  const double depth_m = offset.dot(forward);
  if (depth_m < 1e-3) return std::nullopt;
  const double px_per_m = focal_px / depth_m;
  return Eigen::Vector3d(0.5 * size.width + offset.dot(right) * px_per_m, 0.5 * size.height - offset.dot(up) * px_per_m, depth_m);
}

Eigen::Vector3d OrbitCamera::ray_through(const Eigen::Vector2d& pixel, PixelSize size) const {
  const Eigen::Vector2d offset = (pixel - middle(size)) / focal_px(size);
  return (forward() + offset.x() * right() - offset.y() * up()).normalized();
}

void OrbitCamera::orbit(double dx_px, double dy_px) {
  azimuth_rad = std::remainder(azimuth_rad + dx_px * radians_per_px, 2.0 * std::numbers::pi);
  elevation_rad = std::clamp(elevation_rad + dy_px * radians_per_px, least_elevation_rad, most_elevation_rad);
}

void OrbitCamera::pan(double dx_px, double dy_px, PixelSize size) {
  const double metres_per_px = distance_m / focal_px(size);
  target_m += (-dx_px * right() + dy_px * up()) * metres_per_px;
}

void OrbitCamera::zoom_at(const Eigen::Vector2d& pixel, double factor, PixelSize size) {
  const double before_m = distance_m;
  distance_m = std::clamp(distance_m / factor, least_distance_m, most_distance_m);
  // What lies under the cursor at the target's depth stays under it.
  const Eigen::Vector2d offset = (pixel - middle(size)) / focal_px(size);
  target_m += (before_m - distance_m) * (offset.x() * right() - offset.y() * up());
}

}  // namespace stemwise::render
