#include "render/flight.hpp"

#include <algorithm>
#include <cmath>

namespace stemwise::render {
namespace {

double eased(double elapsed_s) {
  const double t = std::clamp(elapsed_s / flight_s, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double between(double from, double to, double t) { return t >= 1.0 ? to : from * std::pow(to / from, t); }

}  // namespace

MapCamera Flight::map() const {
  const double t = eased(elapsed_s);
  return {map_from.centre_m + t * (map_to.centre_m - map_from.centre_m), between(map_from.metres_per_px, map_to.metres_per_px, t)};
}

OrbitCamera Flight::orbit() const {
  const double t = eased(elapsed_s);
  OrbitCamera camera = orbit_to;
  camera.target_m = orbit_from.target_m + t * (orbit_to.target_m - orbit_from.target_m);
  camera.distance_m = between(orbit_from.distance_m, orbit_to.distance_m, t);
  return camera;
}

}  // namespace stemwise::render
