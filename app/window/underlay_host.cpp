#include "app/window/underlay_host.hpp"

namespace stemwise {

static_assert(static_cast<int>(render::CloudShade::height) == static_cast<int>(ui::CloudShade::height));

bool is_underlay(const std::string& path) { return underlay_kind_of(path).has_value() && !path.ends_with(".asc") && !path.ends_with(".ASC"); }

int UnderlayHost::begin(int id, InventoryId frame, UnderlayRequest request) {
  Entry& entry = entries_[id];
  entry.frame = frame;
  entry.request = std::move(request);
  return entry.reading = ++last_reading_;
}

bool UnderlayHost::is_awaited(int id, int reading) const {
  const auto found = entries_.find(id);
  return found != entries_.end() && found->second.job && found->second.reading == reading;
}

void UnderlayHost::take(int id, UnderlayData data) {
  Entry& entry = entries_[id];
  entry.data = std::move(data);
  entry.job.reset();
}

void UnderlayHost::fail(int id) {
  entries_[id].data.reset();
  entries_[id].job.reset();
}

void UnderlayHost::forget(int id) { entries_.erase(id); }

InventoryId UnderlayHost::frame_of(int id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? InventoryId{} : found->second.frame;
}

std::optional<int> UnderlayHost::job_of(int id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? std::nullopt : found->second.job;
}

bool UnderlayHost::is_stale(int id, const UnderlayRequest& now) const {
  const auto found = entries_.find(id);
  if (found == entries_.end()) return true;
  const UnderlayRequest& then = found->second.request;
  // The area has a margin: as long as half of it is left nobody sees an edge.
  const Eigen::AlignedBox2d inner(now.area_in_reference_m.min() + 0.1 * now.area_in_reference_m.sizes(), now.area_in_reference_m.max() - 0.1 * now.area_in_reference_m.sizes());
  return !(then.georeference == now.georeference) || !(then.reference_from_local == now.reference_from_local) || !then.area_in_reference_m.contains(inner);
}

std::vector<render::ShownUnderlay> UnderlayHost::shown(const ui::ViewState& view) const {
  std::vector<render::ShownUnderlay> shown;
  if (!view.layers.underlays) return shown;
  for (const ui::Underlay& u : view.underlays) {
    const auto found = entries_.find(u.id);
    if (!u.visible || found == entries_.end() || !found->second.data) continue;
    render::ShownUnderlay one{.opacity = u.opacity, .shade = static_cast<render::CloudShade>(u.shade)};
    if (const auto* raster = std::get_if<0>(&*found->second.data)) one.raster = *raster;
    if (const auto* cloud = std::get_if<1>(&*found->second.data)) one.cloud = *cloud;
    if (u.low_m > ui::Underlay::lowest_m) one.low_m = u.low_m;
    if (u.high_m < ui::Underlay::highest_m) one.high_m = u.high_m;
    shown.push_back(std::move(one));
  }
  return shown;
}

}  // namespace stemwise
