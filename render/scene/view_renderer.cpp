#include "render/scene/view_renderer.hpp"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

#include "render/gl/compositor.hpp"
#include "render/number_text.hpp"
#include "render/overlay.hpp"
#include "render/scene/disc_layer.hpp"
#include "render/scene/line_layer.hpp"
#include "render/scene/stem_layer.hpp"
#include "render/scene/surfaces.hpp"
#include "render/scene/underlay_layers.hpp"
#include "render/scene/vtk_stage.hpp"

namespace stemwise::render {
namespace {

constexpr double most_supersampled_pixels = 6.0e6;
constexpr double grid_px = 52.0;  ///< least distance of grid lines, interface pixels
constexpr std::size_t many_marks = 60'000;
constexpr std::size_t most_points_at_rest = 700'000;
constexpr std::size_t most_points_moving = 60'000;  // where the processor draws

std::string gl_renderer() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name ? name : "";
}

}  // namespace

struct ViewRenderer::Impl {
  VtkStage stage;
  Compositor compositor;
  DiscLayer discs, ghost_discs;
  StemLayer stems, ghost_stems;
  UnderlayLayers underlays;
  LineLayer grid{false}, map_lines{false}, map_links{false}, ground_grid{true}, space_links{true};
  bool is_map_stale = true, is_space_stale = true, surfaces_stale = true;
  ViewKind surfaces_of_kind = ViewKind::map;
  unsigned int scene_texture = 0;
  PixelSize scene_size;
  std::unique_ptr<PaintedImage> overlay;
  bool is_software = false;

  /// Outlines of coverage and of what was seen too seldom.
  static std::vector<LineSegment> outlines(const SceneModel& scene, const HeatGrid& heat, const ViewOptions& options) {
    std::vector<LineSegment> lines = options.coverage ? coverage_outlines(scene) : std::vector<LineSegment>{};
    for (const auto& [a, b] : heat.under_observed_m) lines.push_back({{a.x(), a.y(), 0.0}, {b.x(), b.y(), 0.0}, theme_colours(options.theme).warning, 2.0});
    return lines;
  }

  void fill_map(const SceneModel& scene, const HeatGrid& heat, const ViewOptions& options) {
    discs.fill(scene.marks);
    ghost_discs.fill(scene.ghosts);
    map_lines.fill(outlines(scene, heat, options));
    map_links.fill(options.residuals ? residual_arrows(scene, options.theme)
                   : options.links   ? link_lines(scene, options.theme, true)
                                     : std::vector<LineSegment>{});
    is_map_stale = false;
  }

  void fill_space(const SceneModel& scene, const Ground& ground, const ViewOptions& options) {
    stems.fill(scene.marks);
    ghost_stems.fill(scene.ghosts);
    const ThemeColours& colours = theme_colours(options.theme);
    ground_grid.fill(options.grid ? ground_lines(ground, mix(colours.line, colours.secondary, 0.25).with_alpha(0.8)) : std::vector<LineSegment>{});
    space_links.fill(options.links ? link_lines(scene, options.theme, false) : std::vector<LineSegment>{});
    is_space_stale = false;
  }

  void place_surfaces(const SceneModel& scene, const Ground& ground, const HeatGrid& heat, const ViewOptions& options) {
    const ThemeColours& colours = theme_colours(options.theme);
    stage.clear_surfaces();
    if (options.kind == ViewKind::map && options.coverage)
      for (const CoverageShape& shape : scene.coverages) stage.add_surface(surface_of(shape), mix(colours.map, colours.accent_soft, 0.42), false);
    if (options.kind == ViewKind::map && !heat.empty()) stage.add_surface(surface_of(heat, options.theme), {}, false);
    if (options.kind == ViewKind::space && options.ground && !ground.empty())
      stage.add_surface(surface_of(ground), options.theme == Theme::dark ? mix(colours.canvas, colours.accent_soft, 0.75) : mix(colours.accent_soft, colours.line, 0.45), true);
    surfaces_of_kind = options.kind;
    surfaces_stale = false;
  }

  void fill_grid(const SceneModel& scene, const HeatGrid& heat, const Projection& view, const ViewOptions& options) {
    if (!options.grid) return grid.fill({});
    const double step_m = nice_step(grid_px * view.px_scale * view.map.metres_per_px);
    const Eigen::Vector2d a = view.map.world_at({0.0, 0.0}, view.size);
    const Eigen::Vector2d b = view.map.world_at({double(view.size.width), double(view.size.height)}, view.size);
    grid.fill(grid_lines(a.cwiseMin(b), a.cwiseMax(b), scene.origin_m.head<2>(), step_m, heat.empty() ? theme_colours(options.theme).grid : theme_colours(options.theme).grid.with_alpha(0.3)));
  }

  /// Resolution of the drawn scene against the picture: less while dragging where the processor draws, more at rest in 3D.
  double resolution(const SceneModel& scene, const Projection& view, const ViewOptions& options) const {
    const double pixels = static_cast<double>(view.size.width) * view.size.height;
    if (options.kind == ViewKind::map) return options.moving && is_software && (scene.marks.size() > many_marks || pixels > 1.6e6) ? 0.5 : 1.0;
    if (options.moving) return is_software ? 0.5 : 1.0;
    return 4.0 * pixels <= most_supersampled_pixels ? 2.0 : 1.0;
  }

  std::vector<Layer*> layers(const SceneModel& scene, const ViewOptions& options) {
    std::vector<Layer*> shown = underlays.layers();
    if (options.kind == ViewKind::space) {
      shown.insert(shown.end(), {&ground_grid, &stems, &ghost_stems, &space_links});
      return shown;
    }
    shown.insert(shown.end(), {&grid, &map_lines, &discs, &ghost_discs});
    if (!options.moving || !is_software || scene.links.size() < many_marks / 3 || options.residuals) shown.push_back(&map_links);
    return shown;
  }
};

ViewRenderer::ViewRenderer() {
  glewExperimental = GL_TRUE;
  glewInit();
  impl_ = std::make_unique<Impl>();
  const std::string name = gl_renderer();
  impl_->is_software = name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos;
}

ViewRenderer::~ViewRenderer() = default;

void ViewRenderer::forget_scene() {
  impl_->is_map_stale = impl_->is_space_stale = impl_->surfaces_stale = true;
  impl_->underlays.forget_scene();
}

void ViewRenderer::draw_scene(const SceneModel& scene, const Ground& ground, const HeatGrid& heat, const Projection& projection,
                              const ViewOptions& options) {
  const bool is_map = options.kind == ViewKind::map;
  if (is_map && impl_->is_map_stale) impl_->fill_map(scene, heat, options);
  if (!is_map && impl_->is_space_stale) impl_->fill_space(scene, ground, options);
  if (impl_->surfaces_stale || impl_->surfaces_of_kind != options.kind) impl_->place_surfaces(scene, ground, heat, options);
  impl_->underlays.sync(options, scene, ground);
  const double resolution = impl_->resolution(scene, projection, options);
  const PixelSize size{std::max(1, static_cast<int>(std::lround(projection.size.width * resolution))),
                       std::max(1, static_cast<int>(std::lround(projection.size.height * resolution)))};
  FrameView view{.size = size, .px_scale = projection.px_scale * resolution, .dbh_exaggeration = projection.dbh_exaggeration, .is_moving = options.moving, .is_map = is_map, .theme = options.theme};
  const auto clouds = std::count_if(options.underlays.begin(), options.underlays.end(), [](const ShownUnderlay& u) { return u.cloud != nullptr; });
  view.most_points = (options.moving && impl_->is_software ? most_points_moving : most_points_at_rest) / static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, clouds));
  if (is_map) {
    impl_->fill_grid(scene, heat, projection, options);
    view.px_per_m = resolution / projection.map.metres_per_px;
    view.fill_alpha = scene.shows_sightings && scene.side_frames.empty() ? 0.10 : 0.34;
    const bool has_image = std::any_of(options.underlays.begin(), options.underlays.end(), [](const ShownUnderlay& u) { return u.raster != nullptr; });
    if (has_image || !heat.empty()) view.backing = 0.85;
    impl_->stage.look_down(projection.map, projection.size);
  } else {
    const double radius_m = 0.5 * (scene.high_m - scene.low_m).norm() + 30.0;
    view.eye_m = projection.orbit.eye_m().cast<float>();
    view.forward = projection.orbit.forward().cast<float>();
    view.focal_px = projection.orbit.focal_px(size);
    view.px_per_m = 1.0;
    view.fog_start_m = projection.orbit.distance_m;
    view.fog_end_m = projection.orbit.distance_m + 2.5 * radius_m;
    impl_->stage.look(projection.orbit, projection.size, radius_m);
  }
  impl_->stage.set_layers(impl_->layers(scene, options));
  impl_->scene_size = size;
  impl_->scene_texture = impl_->stage.render(size, view, theme_colours(options.theme).map);
}

void ViewRenderer::draw_overlay(const SceneModel& scene, const Projection& projection, const ViewOptions& options) {
  auto& paper = impl_->overlay;
  if (!paper || paper->size() != projection.size || paper->scale() != projection.px_scale)
    paper = std::make_unique<PaintedImage>(projection.size, projection.px_scale);
  {
    const Canvas canvas(paper->cairo());
    paint_overlay(canvas, scene, projection, options);
  }
  impl_->compositor.take_overlay(paper->words(), paper->stride_words(), projection.size);
  paper->mark_changed();
}

std::uint32_t ViewRenderer::compose(PixelSize size) { return impl_->compositor.compose(impl_->scene_texture, impl_->scene_size, size); }
std::uint32_t ViewRenderer::texture() const { return impl_->compositor.texture(); }
Image ViewRenderer::read() const { return impl_->compositor.read(); }
std::string ViewRenderer::renderer_name() const { return gl_renderer(); }

}  // namespace stemwise::render
