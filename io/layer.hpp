#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace stemwise {

/// A cell of a layer: nothing, a whole number, a number, or text.
using LayerValue = std::variant<std::monostate, std::int64_t, double, std::string>;

enum class ColumnType { integer, real, text };

struct LayerColumn {
  std::string name;
  ColumnType type = ColumnType::text;
  int decimals = 3;         ///< of a real in text formats
  std::string description;  ///< with its unit, for data dictionaries
};

enum class LayerGeometry { none, point, line, polygon };

/// One row: its values by column, and its corners in the layer's system (one for a point; a polygon's ring is not closed); a
/// height that nobody knows is NaN.
struct LayerFeature {
  std::vector<LayerValue> values;
  std::vector<Eigen::Vector3d> corners;
};

/// A table with a place on the map: what every export and the project file's map layers are made of.
struct Layer {
  std::string name;
  std::string title;
  LayerGeometry geometry = LayerGeometry::none;
  std::optional<int> epsg;  ///< of the corners; none: local coordinates in metres
  std::vector<LayerColumn> columns;
  std::vector<LayerFeature> features;
};

}  // namespace stemwise
