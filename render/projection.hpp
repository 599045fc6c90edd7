#pragma once
#include <Eigen/Core>
#include <optional>

#include "render/picture.hpp"
#include "render/scene_model.hpp"
#include "render/view_camera.hpp"
#include "render/view_options.hpp"

namespace stemwise::render {

/// One view of a scene at one moment: which camera, how large. The one place where marks become pixels on the CPU.
struct Projection {
  ViewKind kind = ViewKind::map;
  MapCamera map;
  OrbitCamera orbit;
  PixelSize size;
  double px_scale = 1.0;           ///< picture pixels per interface pixel
  double dbh_exaggeration = 1.0;   ///< marks are drawn this many times as thick as they are

  /// Nothing for what lies behind the eye.
  std::optional<Eigen::Vector2d> pixels_of(const Eigen::Vector3d& world_m) const;
  /// The mark on the screen: two ends of its axis (equal on the map) and its radius there.
  struct Shape {
    Eigen::Vector2d base_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d top_px = Eigen::Vector2d::Zero();
    double radius_px = 0.0;
    double depth_m = 0.0;  ///< of the base; 0 on the map
  };
  std::optional<Shape> shape_of(const Mark& mark) const { return shape_of(mark, orbit.basis(size)); }
  std::optional<Shape> shape_of(const Mark& mark, const OrbitBasis& basis) const;  ///< for many marks
  bool is_inside(const Eigen::Vector2d& pixel) const;
};

/// How many times their size circles are drawn so that they are visible at this scale: 30 cm become about 7 pixels, less
/// where trees would overlap, and 1 as soon as true size is larger.
double dbh_exaggeration(double metres_per_px, double spacing_m, double px_scale);
/// The same in 3D: 30 cm become at least about 3.5 pixels at the target's distance, at most four times their size.
double dbh_exaggeration(const OrbitCamera& camera, PixelSize size, double px_scale);

/// The radius on the map of a stem of this diameter.
inline constexpr double least_disc_radius_px = 1.1;
double disc_radius_px(double dbh_m, double px_per_m, double exaggeration, double px_scale);

/// The nearest mark within the tolerance; in 3D the one in front among those hit. Index into scene.marks.
struct Hit {
  std::size_t mark = 0;
  double distance_px = 0.0;
};
std::optional<Hit> pick_mark(const SceneModel& scene, const Projection& projection, const Eigen::Vector2d& pixel, double tolerance_px);

}  // namespace stemwise::render
