#pragma once
#include "core/base/result.hpp"
#include "core/jobs/progress.hpp"
#include "core/underlay/cloud_underlay.hpp"
#include "io/underlay/file_placement.hpp"

namespace stemwise {

/// Takes a file's points in the file's coordinates, one by one, and keeps what lies near the stems, thinned.
class CloudCollector {
 public:
  explicit CloudCollector(const FilePlacement& placement);

  void add(const RawPoint& point) {
    ++offered_;
    box_.extend(point.position.head<2>());
    if (area_.contains(Eigen::Vector2d(point.position.head<2>()))) thinner_.add(point);
  }
  /// In the reference's frame. Failure where nothing lies near the stems.
  Result<CloudUnderlay> finish(const UnderlayRequest& request, const Progress& progress);

 private:
  const FilePlacement& placement_;
  Eigen::AlignedBox2d area_;
  Eigen::AlignedBox2d box_;  ///< of all points offered
  std::int64_t offered_ = 0;
  CloudThinner thinner_;
};

}  // namespace stemwise
