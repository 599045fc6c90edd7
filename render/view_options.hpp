#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/ids.hpp"
#include "core/geometry/rigid_transform.hpp"
#include "render/color_by.hpp"
#include "render/palette.hpp"

namespace stemwise {
struct CloudUnderlay;
struct RasterUnderlay;
}  // namespace stemwise

namespace stemwise::render {

enum class ViewKind { map, space };  ///< "Map" and "3D"

/// An inventory shown a second time, hollow, at another pose: a proposal, the second-best pose, before an alignment.
struct Ghost {
  InventoryId inventory;
  RigidTransform reference_from_inventory;
  bool operator==(const Ghost&) const = default;
};

/// A smooth coloured surface under the marks of the map.
enum class HeatMap { none, density, times_seen, residual };

/// What a cloud's points are coloured by.
enum class CloudShade { colour, intensity, height };

/// A picture or a point cloud under the stems; one of the two. Never changed while it is shown.
struct ShownUnderlay {
  std::shared_ptr<const RasterUnderlay> raster;
  std::shared_ptr<const CloudUnderlay> cloud;
  double opacity = 1.0;
  double low_m = -1e9, high_m = 1e9;  ///< cloud: only points so high above the ground
  CloudShade shade = CloudShade::height;
  bool operator==(const ShownUnderlay&) const = default;
};

/// What is shown and how; a plain value that the window keeps.
struct ViewOptions {
  ViewKind kind = ViewKind::map;
  ColorBy color_by = ColorBy::fate;
  Theme theme = Theme::light;
  std::vector<InventoryId> hidden;  ///< all others are shown
  bool links = true;                ///< lines between the sightings of one tree
  bool residuals = false;           ///< map: the same lines as arrows, lengthened so that they are visible
  HeatMap heat = HeatMap::none;     ///< map
  bool labels = true;               ///< tree ids, thinning out with the scale
  bool coverage = true;
  bool grid = true;
  bool ground = true;               ///< 3D
  bool legend = true;
  bool scale_bar = true;            ///< map
  bool north_arrow = true;
  std::string title;                ///< top left, for pictures that leave the program; empty in the window
  std::vector<TreeId> selected;
  std::vector<StemRef> selected_stems;  ///< of inventories without a place: they have no tree yet
  TreeId hovered;
  std::optional<Ghost> ghost;
  std::vector<ShownUnderlay> underlays;  ///< lowest first
  bool moving = false;  ///< the camera is being dragged: less detail, so that it stays smooth
  bool operator==(const ViewOptions&) const = default;
};

}  // namespace stemwise::render
