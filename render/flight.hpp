#pragma once
#include "render/view_camera.hpp"

namespace stemwise::render {

inline constexpr double flight_s = 0.12;

/// A short way from one view to another: eased, zoom in even steps of its logarithm.
struct Flight {
  MapCamera map_from, map_to;
  OrbitCamera orbit_from, orbit_to;
  double elapsed_s = 0.0;

  MapCamera map() const;
  OrbitCamera orbit() const;
};

}  // namespace stemwise::render
