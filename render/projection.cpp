#include "render/projection.hpp"

#include <algorithm>
#include <cmath>

namespace stemwise::render {
namespace {

constexpr double typical_dbh_m = 0.3;
constexpr double wanted_radius_px = 7.0;

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length_sq = along.squaredNorm();
  const double t = length_sq > 1e-12 ? std::clamp((p - a).dot(along) / length_sq, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

std::optional<Hit> pick_on_map(const SceneModel& scene, const Projection& view, const Eigen::Vector2d& pixel, double tolerance_px) {
  std::optional<Hit> best;
  double best_rank = 0.0;
  const Eigen::Vector2d at_m = view.map.world_at(pixel, view.size);
  const double px_per_m = 1.0 / view.map.metres_per_px;
  for (std::size_t i = 0; i < scene.marks.size(); ++i) {
    const Mark& mark = scene.marks[i];
    const double centre_px = (mark.base_m.head<2>() - at_m).norm() * px_per_m;
    const double radius_px = disc_radius_px(mark.dbh_m, px_per_m, view.dbh_exaggeration, view.px_scale);
    const double outside_px = std::max(0.0, centre_px - radius_px);
    if (outside_px > tolerance_px) continue;
    // Inside several circles the smallest wins (it is drawn on top); else the nearest outline.
    const double rank = outside_px > 0.0 ? 1e6 + outside_px : radius_px + 1e-3 * centre_px;
    if (best && rank >= best_rank) continue;
    best = Hit{i, outside_px};
    best_rank = rank;
  }
  return best;
}

std::optional<Hit> pick_in_space(const SceneModel& scene, const Projection& view, const Eigen::Vector2d& pixel, double tolerance_px) {
  std::optional<Hit> best;
  double best_rank = 0.0;
  const OrbitBasis basis = view.orbit.basis(view.size);
  for (std::size_t i = 0; i < scene.marks.size(); ++i) {
    const auto shape = view.shape_of(scene.marks[i], basis);
    if (!shape) continue;
    const double outside_px = std::max(0.0, distance_to_segment(pixel, shape->base_px, shape->top_px) - shape->radius_px);
    if (outside_px > tolerance_px) continue;
    // What the cursor is really on comes before what it is near; among those the one in front.
    const double rank = outside_px <= 1.0 ? shape->depth_m : 1e6 + outside_px * 1e3 + shape->depth_m * 1e-3;
    if (best && rank >= best_rank) continue;
    best = Hit{i, outside_px};
    best_rank = rank;
  }
  return best;
}

}  // namespace

std::optional<Eigen::Vector2d> Projection::pixels_of(const Eigen::Vector3d& world_m) const {
  if (kind == ViewKind::map) return map.pixels_of(world_m.head<2>(), size);
  const auto found = orbit.basis(size).pixels_of(world_m);
  if (!found) return std::nullopt;
  return Eigen::Vector2d(found->head<2>());
}

std::optional<Projection::Shape> Projection::shape_of(const Mark& mark, const OrbitBasis& basis) const {
  if (kind == ViewKind::map) {
    const Eigen::Vector2d at = map.pixels_of(mark.base_m.head<2>(), size);
    return Shape{at, at, disc_radius_px(mark.dbh_m, 1.0 / map.metres_per_px, dbh_exaggeration, px_scale), 0.0};
  }
  const auto base = basis.pixels_of(mark.base_m);
  const auto top = basis.pixels_of(mark.base_m + mark.height_m * mark.axis);
  if (!base || !top) return std::nullopt;
  const double radius_px = std::max(0.6 * px_scale, 0.5 * mark.dbh_m * dbh_exaggeration * basis.focal_px / base->z());
  return Shape{base->head<2>(), top->head<2>(), radius_px, base->z()};
}

bool Projection::is_inside(const Eigen::Vector2d& pixel) const {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < size.width && pixel.y() < size.height;
}

double dbh_exaggeration(double metres_per_px, double spacing_m, double px_scale) {
  const double true_px = 0.5 * typical_dbh_m / metres_per_px;
  const double shown_px = std::max(true_px, std::min(wanted_radius_px * px_scale, 0.27 * spacing_m / metres_per_px));
  return std::max(1.0, shown_px / true_px);
}

double dbh_exaggeration(const OrbitCamera& camera, PixelSize size, double px_scale) {
  const double true_px = typical_dbh_m * camera.focal_px(size) / camera.distance_m;
  return std::clamp(3.5 * px_scale / std::max(true_px, 1e-6), 1.0, 4.0);
}

double disc_radius_px(double dbh_m, double px_per_m, double exaggeration, double px_scale) {
  return std::max(0.5 * dbh_m * px_per_m * exaggeration, least_disc_radius_px * px_scale);
}

std::optional<Hit> pick_mark(const SceneModel& scene, const Projection& projection, const Eigen::Vector2d& pixel, double tolerance_px) {
  return projection.kind == ViewKind::map ? pick_on_map(scene, projection, pixel, tolerance_px)
                                          : pick_in_space(scene, projection, pixel, tolerance_px);
}

}  // namespace stemwise::render
