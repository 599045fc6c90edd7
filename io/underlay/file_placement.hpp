#pragma once
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/underlay/thin_cloud.hpp"
#include "io/underlay/underlay_request.hpp"

namespace stemwise {

/// The way from a file's coordinates to the reference's frame and back: by the project's georeference where the file names a
/// coordinate system, else as local coordinates.
class FilePlacement {
 public:
  /// `wkt`: the file's coordinate system; empty: it names none. Failure where it names one and the project has no
  /// georeference, or where no way leads from one to the other.
  static Result<FilePlacement> of(const std::string& wkt, const UnderlayRequest& request);
  FilePlacement(FilePlacement&&) noexcept;
  FilePlacement& operator=(FilePlacement&&) noexcept;
  ~FilePlacement();

  /// Nothing where a point has no place on the other side. Heights in metres on both sides.
  std::optional<Eigen::Vector3d> reference_from_file(const Eigen::Vector3d& point) const;
  std::optional<Eigen::Vector3d> file_from_reference(const Eigen::Vector3d& point_m) const;
  /// Box around the request's area in the file's coordinates; empty where it has no place there.
  Eigen::AlignedBox2d area_in_file() const;
  /// Of the file's axes near the area; z as the file's system names it, else 1.
  Eigen::Vector3d metres_per_unit() const;
  std::string system() const;  ///< for people; empty: local coordinates

 private:
  struct Impl;
  explicit FilePlacement(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// "coordinates from 0.0, 0.0 to 40.0, 40.0".
std::string box_text(const Eigen::AlignedBox2d& box);
/// A file whose coordinates are elsewhere: `file_box` in its own coordinates.
Issue elsewhere(const UnderlayRequest& request, const FilePlacement& placement, const Eigen::AlignedBox2d& file_box);

}  // namespace stemwise
