#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.hpp"

namespace stemwise {

inline constexpr int wgs84_epsg = 4326;

/// Takes coordinates from one EPSG code to another by PROJ; always east (or longitude) first, degrees for geographic ones.
/// Heights pass unchanged between horizontal systems.
class CrsTransform {
 public:
  static Result<CrsTransform> between(int from_epsg, int to_epsg);
  CrsTransform(CrsTransform&&) noexcept;
  CrsTransform& operator=(CrsTransform&&) noexcept;
  ~CrsTransform();

  /// Nothing where the point has no place in the target.
  std::optional<Eigen::Vector3d> operator()(const Eigen::Vector3d& point) const;

 private:
  struct Impl;
  explicit CrsTransform(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The code of "EPSG:25832", in capitals or not; nothing for any other text. Whether there is such a system is not asked.
std::optional<int> epsg_from(const std::string& text);
/// EPSG code of the UTM zone (WGS 84) of a position in degrees; zones 32V and 31X..37X as they are.
int utm_epsg_of(double longitude_deg, double latitude_deg);
/// True for EPSG codes that PROJ knows.
bool is_known_epsg(int epsg);
bool is_geographic_epsg(int epsg);
/// True where the system's area of use, as EPSG has it, holds the position, or comes within `margin_deg`; also when it has none.
bool is_in_area_of_use(int epsg, double latitude_deg, double longitude_deg, double margin_deg);
/// Metres per unit of the axes of a projected system; nothing for others.
std::optional<double> metres_per_unit_of_epsg(int epsg);
/// "WGS 84 / UTM zone 55S"; "EPSG:1234" when unknown.
std::string crs_name(int epsg);
/// Well-known text for a GDAL data set; empty when unknown.
std::string crs_wkt(int epsg);

}  // namespace stemwise
