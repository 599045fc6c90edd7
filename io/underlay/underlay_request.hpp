#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "core/geodesy/georeference.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {

/// What is to be laid under the stems, and where these are.
struct UnderlayRequest {
  std::string path;
  Georeference georeference;                ///< of the reference's frame
  RigidTransform reference_from_local;      ///< for files that name no coordinate system
  Eigen::AlignedBox2d area_in_reference_m;  ///< of the stems, with a margin: nothing else is read
};

enum class UnderlayKind { raster, cloud };

std::string lower_suffix(const std::string& path);  ///< ".las", also of SCAN.LAS
/// By the file's suffix; nothing for a file that is neither.
std::optional<UnderlayKind> underlay_kind_of(const std::string& path);

}  // namespace stemwise
