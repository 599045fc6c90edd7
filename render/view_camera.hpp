#pragma once
#include <Eigen/Core>
#include <optional>

#include "render/picture.hpp"

namespace stemwise::render {

// The two cameras, as plain mathematics: pictures, picking and tests share them, VTK is only told. World coordinates are
// metres relative to the scene's origin; pixels have their origin top left, y down.

/// Straight down, north (+y) up, parallel.
struct MapCamera {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double metres_per_px = 0.1;

  Eigen::Vector2d pixels_of(const Eigen::Vector2d& world_m, PixelSize size) const;
  Eigen::Vector2d world_at(const Eigen::Vector2d& pixel, PixelSize size) const;
  void pan(double dx_px, double dy_px);
  void zoom_at(const Eigen::Vector2d& pixel, double factor, PixelSize size);
  bool operator==(const MapCamera& o) const { return centre_m == o.centre_m && metres_per_px == o.metres_per_px; }
};

/// A perspective view worked out once, for projecting many points.
struct OrbitBasis {
  Eigen::Vector3d eye_m, forward, right, up;
  double focal_px = 1.0;
  PixelSize size;
  /// x, y in pixels and the depth along the view in metres; nothing behind the eye.
  std::optional<Eigen::Vector3d> pixels_of(const Eigen::Vector3d& world_m) const;
};

/// Turns around a target; perspective.
struct OrbitCamera {
  Eigen::Vector3d target_m = Eigen::Vector3d::Zero();
  double distance_m = 50.0;
  double azimuth_rad = 0.0;     ///< of the view direction, clockwise from north seen from above
  double elevation_rad = 0.5;   ///< of the eye above the target's horizon
  double field_of_view_rad = 0.5235987755982988;  ///< of the picture's height

  Eigen::Vector3d eye_m() const;
  Eigen::Vector3d forward() const;  ///< unit, from the eye to the target
  Eigen::Vector3d right() const;
  Eigen::Vector3d up() const;
  double focal_px(PixelSize size) const;  ///< pixels of one metre at one metre
  OrbitBasis basis(PixelSize size) const { return {eye_m(), forward(), right(), up(), focal_px(size), size}; }
  /// Unit direction from the eye through the pixel.
  Eigen::Vector3d ray_through(const Eigen::Vector2d& pixel, PixelSize size) const;
  void orbit(double dx_px, double dy_px);
  void pan(double dx_px, double dy_px, PixelSize size);
  void zoom_at(const Eigen::Vector2d& pixel, double factor, PixelSize size);
  bool operator==(const OrbitCamera& o) const {
    return target_m == o.target_m && distance_m == o.distance_m && azimuth_rad == o.azimuth_rad && elevation_rad == o.elevation_rad;
  }
};

}  // namespace stemwise::render
