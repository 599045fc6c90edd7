#include "io/underlay/cloud_collector.hpp"

#include "core/underlay/arrange_cloud.hpp"
#include "io/underlay/read_cloud_underlay.hpp"

namespace stemwise {
namespace {

constexpr std::size_t points_per_check = 4096;

}  // namespace

CloudCollector::CloudCollector(const FilePlacement& placement)
    : placement_(placement), area_(placement.area_in_file()), thinner_(most_cloud_points, finest_cloud_spacing_m, placement.metres_per_unit()) {}

Result<CloudUnderlay> CloudCollector::finish(const UnderlayRequest& request, const Progress& progress) {
  if (thinner_.points().empty()) {
    if (offered_ == 0) return Result<CloudUnderlay>::failure(Issue{Severity::error, request.path, 0, {}, "it holds no points", "choose another file"});
    return Result<CloudUnderlay>::failure(elsewhere(request, placement_, box_));
  }
  const double unit_z_m = placement_.metres_per_unit().z();
  std::vector<RawPoint> points = thinner_.take();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % points_per_check == 0) progress.at(0.8 * static_cast<double>(i) / static_cast<double>(points.size()), "Placing points");
    RawPoint point = points[i];
    point.position.z() *= unit_z_m;
    const auto place = placement_.reference_from_file(point.position);
    if (!place) continue;
    point.position = *place;
    points[kept++] = point;
  }
  points.resize(kept);
  progress.at(0.8, "Finding the ground");
  CloudUnderlay cloud = arrange_cloud(std::move(points), thinner_.spacing_m());
  cloud.points_in_file = offered_;
  cloud.system = placement_.system();
  return cloud;
}

}  // namespace stemwise
