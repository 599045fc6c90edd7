#include "io/project_degrees.hpp"

#include <algorithm>
#include <cmath>

#include "io/crs.hpp"

namespace stemwise {
namespace {

/// Degrees to metres in the UTM zone of the middle stem; stems without a place there are left out.
Issues project_to_utm(std::vector<Stem>& stems, int from_epsg, std::optional<int>& epsg, std::vector<std::string>& notes) {
  std::vector<double> lon, lat;
  const auto to_degrees = CrsTransform::between(from_epsg, wgs84_epsg);
  if (!to_degrees) return to_degrees.issues;
  for (const Stem& s : stems) {
    if (const auto p = (*to_degrees)({s.x_m, s.y_m, 0.0})) lon.push_back(p->x()), lat.push_back(p->y());
  }
  if (lon.empty()) return {};
  epsg = utm_epsg_of(*median_of(lon), *median_of(lat));
  const auto project = CrsTransform::between(from_epsg, *epsg);
  if (!project) return project.issues;
  for (Stem& s : stems) {
    if (const auto p = (*project)({s.x_m, s.y_m, 0.0})) s.x_m = p->x(), s.y_m = p->y();
  }
  notes.push_back("positions projected to " + crs_name(*epsg) + " (EPSG:" + std::to_string(*epsg) + ")");
  return {};
}

/// Degrees that call themselves x and y: more than three stems on every square metre if they were metres.
bool are_degrees_in_disguise(const std::vector<Stem>& stems, const StemColumns& columns) {
  if (columns.position.scheme != PositionScheme::cartesian || stems.size() < 5) return false;
  double low_x = 1e300, low_y = 1e300, high_x = -1e300, high_y = -1e300;
  for (const Stem& s : stems) {
    low_x = std::min(low_x, s.x_m), high_x = std::max(high_x, s.x_m);
    low_y = std::min(low_y, s.y_m), high_y = std::max(high_y, s.y_m);
  }
  if (std::max(std::abs(low_x), std::abs(high_x)) > 180.0 || std::max(std::abs(low_y), std::abs(high_y)) > 90.0) return false;
  return (high_x - low_x) * (high_y - low_y) * 3.0 < static_cast<double>(stems.size());
}

}  // namespace

Issues project_degrees(const StemTable& table, const StemColumns& columns, Inventory& inventory) {
  const std::optional<int> epsg = inventory.source.epsg;
  Issues issues;
  std::optional<int> geographic = columns.position.scheme == PositionScheme::geographic ? std::optional(wgs84_epsg) : std::nullopt;
  if (!geographic && epsg && is_geographic_epsg(*epsg)) geographic = epsg;
  if (!geographic && !epsg && are_degrees_in_disguise(inventory.stems, columns)) {
    geographic = wgs84_epsg;
    issues.push_back({Severity::warning, table.file, table.header_row, table.header[columns.position.first],
                      "positions look like longitude and latitude in degrees and were read as such", "if that is wrong: --unit x=m"});
  }
  if (!geographic) return issues;
  for (Issue& issue : project_to_utm(inventory.stems, *geographic, inventory.source.epsg, inventory.source.notes)) issues.push_back(std::move(issue));
  return issues;
}

}  // namespace stemwise
