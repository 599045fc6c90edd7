#include "io/underlay/read_cloud_underlay.hpp"

#include <filesystem>

#include "io/underlay/las_points.hpp"
#include "io/underlay/pcl_points.hpp"

namespace stemwise {

Result<CloudUnderlay> read_cloud_underlay(const UnderlayRequest& request, const Progress& progress) {
  const std::string suffix = lower_suffix(request.path);
  progress.at(0.0, "Opening " + std::filesystem::path(request.path).filename().string());
  return suffix == ".pcd" || suffix == ".ply" ? read_pcl_points(request, progress) : read_las_points(request, progress);
}

}  // namespace stemwise
