#include "render/scene/underlay_layers.hpp"

#include <algorithm>
#include <cmath>

namespace stemwise::render {
namespace {

constexpr double same_ground_m = 2.0;
constexpr std::size_t points_asked = 2000;

/// The same points in the same colours, at most through other glass.
bool is_same_cloud(const ShownUnderlay& a, const ShownUnderlay& b) { return a.low_m == b.low_m && a.high_m == b.high_m && a.shade == b.shade; }

}  // namespace

double height_shift_m(const CloudUnderlay& cloud, const SceneModel& scene, const Ground& ground) {
  if (!scene.has_terrain || ground.empty() || cloud.points.empty()) return 0.0;
  std::vector<double> gaps_m;
  const Eigen::Vector3d origin_m = cloud.origin_in_reference_m - scene.origin_m;
  const std::size_t step = std::max<std::size_t>(1, cloud.points.size() / points_asked);
  for (std::size_t i = 0; i < cloud.points.size(); i += step) {
    const CloudPoint& p = cloud.points[i];
    const double own_m = origin_m.z() + p.z_m - p.above_ground_m;
    gaps_m.push_back(ground.height_at_m({origin_m.x() + p.x_m, origin_m.y() + p.y_m}) - own_m);
  }
  const auto middle = gaps_m.begin() + static_cast<std::ptrdiff_t>(gaps_m.size() / 2);
  std::nth_element(gaps_m.begin(), middle, gaps_m.end());
  return std::abs(*middle) > same_ground_m ? *middle : 0.0;
}

void UnderlayLayers::forget_scene() {
  for (Entry& entry : entries_) entry.is_placed = false;
}

UnderlayLayers::Entry UnderlayLayers::make(const ShownUnderlay& shown) {
  Entry entry{.shown = shown};
  if (shown.raster) entry.raster = std::make_unique<RasterLayer>(*shown.raster);
  if (shown.cloud) entry.cloud = std::make_unique<CloudLayer>();
  return entry;
}

void UnderlayLayers::place(Entry& entry, const SceneModel& scene, const Ground& ground, const ViewOptions& options) {
  const bool is_map = options.kind == ViewKind::map;
  if (entry.raster) entry.raster->place(*entry.shown.raster, scene.origin_m, is_map ? nullptr : &ground);
  if (entry.cloud)
    entry.cloud->fill(*entry.shown.cloud, entry.shown, {.origin_m = scene.origin_m, .shift_m = height_shift_m(*entry.shown.cloud, scene, ground), .theme = options.theme, .is_flat = !scene.has_terrain});
  entry.is_placed = true;
  entry.is_map = is_map;
}

void UnderlayLayers::sync(const ViewOptions& options, const SceneModel& scene, const Ground& ground) {
  const bool is_map = options.kind == ViewKind::map;
  std::vector<Entry> next;
  for (const ShownUnderlay& wanted : options.underlays) {
    const auto same = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.shown.raster == wanted.raster && e.shown.cloud == wanted.cloud && (e.raster || e.cloud); });
    Entry entry = same == entries_.end() ? make(wanted) : std::move(*same);
    if (entry.cloud && !is_same_cloud(entry.shown, wanted)) entry.is_placed = false;
    if (entry.raster && entry.is_map != is_map) entry.is_placed = false;
    entry.shown = wanted;
    if (!entry.is_placed) place(entry, scene, ground, options);
    if (entry.raster) entry.raster->set_opacity(wanted.opacity);
    if (entry.cloud) entry.cloud->set_opacity(wanted.opacity);
    next.push_back(std::move(entry));
  }
  entries_ = std::move(next);
}

void UnderlayLayers::GroundForgetter::draw(const FrameView& view) {
  if (view.is_map) return;
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
}

std::vector<Layer*> UnderlayLayers::layers() {
  std::vector<Layer*> all;
  for (const Entry& entry : entries_)
    if (entry.raster) all.push_back(entry.raster.get());
  if (std::any_of(entries_.begin(), entries_.end(), [](const Entry& e) { return e.cloud != nullptr; })) all.push_back(&ground_forgetter_);
  for (const Entry& entry : entries_)
    if (entry.cloud) all.push_back(entry.cloud.get());
  return all;
}

}  // namespace stemwise::render
