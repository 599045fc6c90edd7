#include "render/viewport.hpp"

#include <algorithm>
#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "core/geometry/polygon.hpp"
#include "render/flight.hpp"
#include "render/ground.hpp"
#include "render/heat_map.hpp"
#include "render/projection.hpp"
#include "render/scene/view_renderer.hpp"
#include "render/scene_model.hpp"

namespace stemwise::render {
namespace {

constexpr double fit_margin = 1.03;
constexpr double settle_s = 0.15;

/// What of the options makes other marks; the rest is only drawn differently.
bool is_same_scene(const ViewOptions& a, const ViewOptions& b) {
  return a.color_by == b.color_by && a.theme == b.theme && a.hidden == b.hidden && a.ghost == b.ghost && a.heat == b.heat;
}
/// What only the overlay shows.
bool is_same_drawing(ViewOptions a, const ViewOptions& b) {
  a.legend = b.legend;
  a.scale_bar = b.scale_bar;
  a.north_arrow = b.north_arrow;
  a.labels = b.labels;
  a.title = b.title;
  a.selected = b.selected;
  a.selected_stems = b.selected_stems;
  a.hovered = b.hovered;
  return a == b;
}

/// Which surveys are where: when this changes, the old view means nothing.
std::set<std::pair<InventoryId, bool>> layout_of(const ProjectState& state, const Tables& tables) {
  std::set<std::pair<InventoryId, bool>> layout;
  for (const auto& inventory : state.inventories)
    layout.emplace(inventory->id, std::find(tables.inventories.begin(), tables.inventories.end(), inventory->id) != tables.inventories.end());
  return layout;
}

}  // namespace

struct Viewport::Impl {
  ViewOptions options;
  std::optional<ViewOptions> built_options;
  std::optional<std::uint64_t> revision;
  std::set<std::pair<InventoryId, bool>> layout;
  SceneModel scene;
  Ground ground;
  HeatGrid heat;
  Projection view;
  std::optional<Flight> flight;
  double settling_s = 0.0;  ///< a turn of the wheel has no end: for a moment it counts as moving
  std::unique_ptr<ViewRenderer> renderer;
  std::uint64_t pictures_drawn = 0;
  bool is_moved = false;    ///< by a person since the last fit: then a new size leaves the view where it is
  bool is_fit_pending = true, is_scene_stale = true, is_drawing_stale = true, is_overlay_stale = true;

  void touch() { is_drawing_stale = is_overlay_stale = true; }

  /// The projection of this moment.
  Projection now() const {
    Projection p = view;
    p.kind = options.kind;
    p.dbh_exaggeration = p.kind == ViewKind::map ? dbh_exaggeration(view.map.metres_per_px, scene.spacing_m, view.px_scale)
                                                 : dbh_exaggeration(view.orbit, view.size, view.px_scale);
    return p;
  }

  bool has_size() const { return view.size.width > 0 && view.size.height > 0; }

  /// Free of the tool bar or title above, and in a picture that leaves the program of the legend at its left.
  void fit_map(const Eigen::Vector2d& middle_m, const Eigen::Vector2d& extent_m) {
    const double caption_px = scene.side_frames.empty() ? 0.0 : 26.0;  // names stand above surveys that are shown beside
    const double side_px = 22.0 * view.px_scale, top_px = (54.0 + caption_px) * view.px_scale;
    const double left_px = options.title.empty() || !options.legend || view.size.width < 700 * view.px_scale ? side_px : 240.0 * view.px_scale;
    const double free_width = std::max(80.0, view.size.width - left_px - side_px);
    const double free_height = std::max(80.0, view.size.height - top_px - side_px);
    view.map.metres_per_px = fit_margin * std::max({extent_m.x() / free_width, extent_m.y() / free_height, 5.0 / view.size.height});
    view.map.centre_m = middle_m + 0.5 * view.map.metres_per_px * Eigen::Vector2d(side_px - left_px, top_px - side_px);
  }

  void fit() {
    is_fit_pending = !has_size();
    if (is_fit_pending) return;
    is_moved = false;
    const Eigen::Vector3d middle = 0.5 * (scene.low_m + scene.high_m);
    const Eigen::Vector3d extent = scene.high_m - scene.low_m;
    fit_map(middle.head<2>(), extent.head<2>());
    const double radius_m = std::max(8.0, 0.5 * extent.head<2>().norm());
    const double narrow = std::min(1.0, static_cast<double>(view.size.width) / view.size.height);
    view.orbit.target_m = middle + Eigen::Vector3d(0.0, 0.0, std::min(8.0, 0.12 * radius_m));
    view.orbit.distance_m = 0.78 * radius_m / std::sin(0.5 * view.orbit.field_of_view_rad) / narrow;
    view.orbit.azimuth_rad = 0.5;
    view.orbit.elevation_rad = 0.55;
    flight.reset();
    touch();
  }

  void fly(const Eigen::Vector3d& place_m, double radius_m, bool animated) {
    if (!has_size()) return;
    is_moved = true;
    Flight next{.map_from = view.map, .map_to = view.map, .orbit_from = view.orbit, .orbit_to = view.orbit};
    const double shorter_px = std::min(view.size.width, view.size.height);
    next.map_to.centre_m = place_m.head<2>();
    next.map_to.metres_per_px = std::min(view.map.metres_per_px, 2.0 * radius_m / shorter_px);
    next.orbit_to.target_m = place_m + Eigen::Vector3d(0.0, 0.0, 3.0);
    next.orbit_to.distance_m = std::min(view.orbit.distance_m, 2.2 * radius_m / std::tan(0.5 * view.orbit.field_of_view_rad));
    flight = next;
    advance(animated ? 0.0 : flight_s);
  }

  bool advance(double elapsed_s) {
    if (settling_s > 0.0) {
      settling_s -= elapsed_s;
      if (settling_s <= 0.0) touch();
    }
    if (!flight) return settling_s > 0.0;
    flight->elapsed_s += elapsed_s;
    view.map = flight->map();
    view.orbit = flight->orbit();
    touch();
    if (flight->elapsed_s >= flight_s) flight.reset();
    return flight.has_value();
  }

  std::optional<Eigen::Vector2d> pixels(const Mark* mark) const {
    if (!mark || !has_size()) return std::nullopt;
    const auto shape = now().shape_of(*mark);
    if (!shape) return std::nullopt;
    // In 3D the middle of the stem's lower part: a place where a click hits it.
    const Eigen::Vector2d at = shape->base_px + (options.kind == ViewKind::map ? 0.0 : 0.2) * (shape->top_px - shape->base_px);
    return now().is_inside(at) ? std::optional(at) : std::nullopt;
  }

  /// Ascending, each once: the trees whose base is where `is_wanted` says.
  template <class Test>
  std::vector<TreeId> trees_where(const Test& is_wanted) const {
    const Projection at = now();
    const OrbitBasis basis = at.orbit.basis(at.size);
    std::vector<TreeId> trees;
    for (const Mark& mark : scene.marks) {
      const auto shape = at.shape_of(mark, basis);
      if (mark.tree && shape && is_wanted(shape->base_px)) trees.push_back(mark.tree);
    }
    std::sort(trees.begin(), trees.end());
    trees.erase(std::unique(trees.begin(), trees.end()), trees.end());
    return trees;
  }

  /// Where the ray through a pixel meets the ground.
  std::optional<Eigen::Vector3d> on_ground(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector3d eye = view.orbit.eye_m(), ray = view.orbit.ray_through(pixel, view.size);
    double height_m = ground.height_at_m(view.orbit.target_m.head<2>());
    Eigen::Vector3d place = eye;
    for (int step = 0; step < 8; ++step) {
      const double along_m = (height_m - eye.z()) / ray.z();
      if (!(along_m > 0.0) || !std::isfinite(along_m)) return std::nullopt;
      place = eye + along_m * ray;
      height_m = ground.height_at_m(place.head<2>());
    }
    place.z() = height_m;
    return place;
  }
};

Viewport::Viewport() : impl_(std::make_unique<Impl>()) {}
Viewport::~Viewport() = default;
Viewport::Viewport(Viewport&&) noexcept = default;
Viewport& Viewport::operator=(Viewport&&) noexcept = default;

void Viewport::set_options(const ViewOptions& options) {
  if (options == impl_->options) return;
  if (!is_same_drawing(options, impl_->options)) impl_->is_drawing_stale = true;
  if (options.links != impl_->options.links || options.residuals != impl_->options.residuals || options.coverage != impl_->options.coverage || options.ground != impl_->options.ground ||
      options.grid != impl_->options.grid)
    impl_->is_scene_stale = true;
  impl_->is_overlay_stale = true;
  impl_->options = options;
}

const ViewOptions& Viewport::options() const { return impl_->options; }

void Viewport::sync(const ProjectState& state, const Tables& tables, std::uint64_t revision) {
  Impl& s = *impl_;
  if (s.revision == revision && s.built_options && is_same_scene(*s.built_options, s.options)) return;
  s.scene = build_scene(state, tables, s.options);
  s.ground = estimate_ground(s.scene);
  s.heat = estimate_heat(s.scene, s.options.heat);
  s.scene.heat_legend = s.heat.legend;
  s.built_options = s.options;
  s.revision = revision;
  s.is_scene_stale = true;
  s.touch();
  auto layout = layout_of(state, tables);
  if (layout != s.layout) s.is_fit_pending = true;
  s.layout = std::move(layout);
  if (s.is_fit_pending) s.fit();
}

void Viewport::follow(const Viewport& other) {
  const Projection& there = other.impl_->view;
  Projection& here = impl_->view;
  const bool same = here.map.centre_m == there.map.centre_m && here.map.metres_per_px == there.map.metres_per_px && here.orbit.target_m == there.orbit.target_m &&
                    here.orbit.distance_m == there.orbit.distance_m && here.orbit.azimuth_rad == there.orbit.azimuth_rad && here.orbit.elevation_rad == there.orbit.elevation_rad;
  if (same) return;
  impl_->flight.reset();
  impl_->is_moved = true;
  here.map = there.map;
  here.orbit = there.orbit;
  impl_->touch();
}

bool Viewport::is_dirty() const { return impl_->is_scene_stale || impl_->is_drawing_stale || impl_->is_overlay_stale || impl_->flight; }

std::uint32_t Viewport::render(PixelSize size, double scale) {
  resize(size, scale);
  Impl& s = *impl_;
  if (!s.renderer) s.renderer = std::make_unique<ViewRenderer>();
  if (!s.has_size() || (!s.is_scene_stale && !s.is_drawing_stale && !s.is_overlay_stale)) return s.renderer->texture();
  const Projection projection = s.now();
  ViewOptions options = s.options;
  options.moving |= s.flight.has_value() || s.settling_s > 0.0;
  if (s.is_scene_stale) s.renderer->forget_scene();
  if (s.is_scene_stale || s.is_drawing_stale) s.renderer->draw_scene(s.scene, s.ground, s.heat, projection, options);
  s.renderer->draw_overlay(s.scene, projection, options);
  s.is_scene_stale = s.is_drawing_stale = s.is_overlay_stale = false;
  ++s.pictures_drawn;
  return s.renderer->compose(size);
}

std::uint64_t Viewport::pictures_drawn() const { return impl_->pictures_drawn; }

Image Viewport::image() { return impl_->renderer ? impl_->renderer->read() : Image{}; }
std::string Viewport::renderer_name() const { return impl_->renderer ? impl_->renderer->renderer_name() : ""; }

void Viewport::resize(PixelSize size, double scale) {
  Impl& s = *impl_;
  if (size == s.view.size && scale == s.view.px_scale) return;
  const bool had_size = s.has_size();
  s.view.size = size;
  s.view.px_scale = scale;
  s.touch();
  if (s.is_fit_pending || !had_size || !s.is_moved) s.fit();
}

void Viewport::fit() { impl_->fit(); }

void Viewport::pan(double dx_px, double dy_px) {
  impl_->flight.reset();
  impl_->is_moved = true;
  if (impl_->options.kind == ViewKind::map) {
    impl_->view.map.pan(dx_px, dy_px);
  } else {
    impl_->view.orbit.pan(dx_px, dy_px, impl_->view.size);
  }
  impl_->touch();
}

void Viewport::zoom_at(double x_px, double y_px, double factor) {
  impl_->flight.reset();
  impl_->is_moved = true;
  if (impl_->options.kind == ViewKind::map) {
    impl_->view.map.zoom_at({x_px, y_px}, factor, impl_->view.size);
  } else {
    impl_->view.orbit.zoom_at({x_px, y_px}, factor, impl_->view.size);
    impl_->settling_s = settle_s;
  }
  impl_->touch();
}

void Viewport::orbit(double dx_px, double dy_px) {
  if (impl_->options.kind == ViewKind::map) return;
  impl_->flight.reset();
  impl_->is_moved = true;
  impl_->view.orbit.orbit(dx_px / impl_->view.px_scale, dy_px / impl_->view.px_scale);
  impl_->touch();
}

void Viewport::fly_to(TreeId tree, bool animated) {
  if (const Mark* mark = impl_->scene.find(tree)) impl_->fly(mark->base_m, 5.0 * impl_->scene.spacing_m, animated);
}

void Viewport::fly_to(const Eigen::Vector3d& in_reference_m, double radius_m, bool animated) {
  impl_->fly(in_reference_m - impl_->scene.origin_m, radius_m, animated);
}

bool Viewport::advance(double elapsed_s) { return impl_->advance(elapsed_s); }

double Viewport::metres_per_px() const {
  const Projection& view = impl_->view;
  return impl_->options.kind == ViewKind::map ? view.map.metres_per_px : view.orbit.distance_m / view.orbit.focal_px(view.size);
}

std::optional<Pick> Viewport::pick(double x_px, double y_px, double tolerance_px) const {
  const auto hit = pick_mark(impl_->scene, impl_->now(), {x_px, y_px}, tolerance_px * impl_->view.px_scale);
  if (!hit) return std::nullopt;
  const Mark& mark = impl_->scene.marks[hit->mark];
  return Pick{mark.tree, mark.stem, hit->distance_px};
}

std::vector<TreeId> Viewport::trees_in_rectangle(double x0_px, double y0_px, double x1_px, double y1_px) const {
  const Eigen::AlignedBox2d box(Eigen::Vector2d(std::min(x0_px, x1_px), std::min(y0_px, y1_px)),
                                Eigen::Vector2d(std::max(x0_px, x1_px), std::max(y0_px, y1_px)));
  return impl_->trees_where([&box](const Eigen::Vector2d& pixel) { return box.contains(pixel); });
}

std::vector<TreeId> Viewport::trees_in_polygon(std::span<const Eigen::Vector2d> corners_px) const {
  Polygon polygon;
  polygon.corners_m.assign(corners_px.begin(), corners_px.end());  // here in pixels
  if (polygon.empty()) return {};
  return impl_->trees_where([&polygon](const Eigen::Vector2d& pixel) { return contains(polygon, pixel); });
}

std::optional<WorldPosition> Viewport::world_at(double x_px, double y_px) const {
  const Impl& s = *impl_;
  if (!s.has_size()) return std::nullopt;
  if (s.options.kind == ViewKind::space) {
    const auto place = s.on_ground({x_px, y_px});
    if (!place) return std::nullopt;
    return WorldPosition{*place + s.scene.origin_m, s.scene.reference};
  }
  const Eigen::Vector2d place = s.view.map.world_at({x_px, y_px}, s.view.size);
  for (const SideFrame& frame : s.scene.side_frames) {
    const Eigen::AlignedBox2d box(frame.low_m, frame.high_m);
    const Eigen::Vector2d own = place - frame.scene_from_own_m;
    if (frame.inventory != s.scene.reference && box.contains(place)) return WorldPosition{{own.x(), own.y(), 0.0}, frame.inventory};
  }
  const double height_m = s.scene.has_terrain ? s.ground.height_at_m(place) : 0.0;
  return WorldPosition{Eigen::Vector3d(place.x(), place.y(), height_m) + s.scene.origin_m, s.scene.reference};
}

std::optional<Eigen::Vector2d> Viewport::pixels_of(TreeId tree) const { return impl_->pixels(impl_->scene.find(tree)); }
std::optional<Eigen::Vector2d> Viewport::pixels_of(StemRef stem) const { return impl_->pixels(impl_->scene.find(stem)); }

Eigen::Vector2d Viewport::pixels_of(const Eigen::Vector3d& in_reference_m) const {
  return impl_->now().pixels_of(in_reference_m - impl_->scene.origin_m).value_or(Eigen::Vector2d(-1e6, -1e6));
}

const Legend& Viewport::legend() const { return impl_->scene.legend; }
int Viewport::shown_marks() const { return static_cast<int>(impl_->scene.marks.size()); }

}  // namespace stemwise::render
