#pragma once
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/geodesy/georeference.hpp"

namespace stemwise {

/// One row of a control file, before a tree's label has become a place.
struct ControlRow {
  std::int64_t row = 0;
  std::string tree_id;                           ///< "T-00012"; empty where the row has coordinates
  std::optional<Eigen::Vector3d> in_reference_m; ///< z 0 when the file has none
  bool has_z = false;
  Geodetic on_earth;
  bool has_height = false;
};

/// CSV (any delimiter) with x_m, y_m, z_m or tree_id, and lon, lat, height_m (cli.md, "Files"). Bad rows are warnings that
/// name row and column; a failure when no row is usable.
Result<std::vector<ControlRow>> read_control_points(const std::string& path);

}  // namespace stemwise
