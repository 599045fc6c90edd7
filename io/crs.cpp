#include "io/crs.hpp"

#include <cstdio>
#include <ogr_spatialref.h>

#include <cmath>

#include "io/gdal_session.hpp"

namespace stemwise {
namespace {

std::optional<OGRSpatialReference> system_of(int epsg) {
  OGRSpatialReference system;
  if (epsg <= 0 || system.importFromEPSG(epsg) != OGRERR_NONE) return std::nullopt;
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return system;
}

Issue unknown_system(int epsg) {
  return {Severity::error, {}, 0, {}, "EPSG:" + std::to_string(epsg) + " is no coordinate system that PROJ knows", "look the code up at epsg.io"};
}

struct DeleteTransformation {
  void operator()(OGRCoordinateTransformation* t) const { OGRCoordinateTransformation::DestroyCT(t); }
};

}  // namespace

struct CrsTransform::Impl {
  std::unique_ptr<OGRCoordinateTransformation, DeleteTransformation> transformation;  ///< none: the same system
};

CrsTransform::CrsTransform(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
CrsTransform::CrsTransform(CrsTransform&&) noexcept = default;
CrsTransform& CrsTransform::operator=(CrsTransform&&) noexcept = default;
CrsTransform::~CrsTransform() = default;

Result<CrsTransform> CrsTransform::between(int from_epsg, int to_epsg) {
  const GdalMessages quiet;
  const auto from = system_of(from_epsg);
  const auto to = system_of(to_epsg);
  if (!from) return Result<CrsTransform>::failure(unknown_system(from_epsg));
  if (!to) return Result<CrsTransform>::failure(unknown_system(to_epsg));
  auto impl = std::make_unique<Impl>();
  if (from_epsg != to_epsg) {
    impl->transformation.reset(OGRCreateCoordinateTransformation(&*from, &*to));
    if (!impl->transformation) {
      return Result<CrsTransform>::failure(Issue{Severity::error, {}, 0, {}, "no way from EPSG:" + std::to_string(from_epsg) + " to EPSG:" + std::to_string(to_epsg), {}});
    }
  }
  Result<CrsTransform> result;
  result.value.emplace(CrsTransform(std::move(impl)));
  return result;
}

std::optional<Eigen::Vector3d> CrsTransform::operator()(const Eigen::Vector3d& point) const {
  if (!impl_->transformation) return point;
  const GdalMessages quiet;
  double x = point.x();
  double y = point.y();
  double z = point.z();
  if (!impl_->transformation->Transform(1, &x, &y, &z) || !std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
  return Eigen::Vector3d(x, y, z);
}

std::optional<int> epsg_from(const std::string& text) {
  int epsg = 0;
  char end = 0;
  if (std::sscanf(text.c_str(), "EPSG:%d%c", &epsg, &end) == 1 || std::sscanf(text.c_str(), "epsg:%d%c", &epsg, &end) == 1) return epsg;
  return std::nullopt;
}

int utm_epsg_of(double longitude_deg, double latitude_deg) {
  const double lon = longitude_deg >= 180.0 ? longitude_deg - 360.0 : longitude_deg;
  int zone = static_cast<int>(std::floor((lon + 180.0) / 6.0)) + 1;
  if (latitude_deg >= 56.0 && latitude_deg < 64.0 && lon >= 3.0 && lon < 12.0) zone = 32;  // south-west Norway
  if (latitude_deg >= 72.0 && lon >= 0.0 && lon < 42.0) zone = lon < 9.0 ? 31 : lon < 21.0 ? 33 : lon < 33.0 ? 35 : 37;  // Svalbard
  return (latitude_deg >= 0.0 ? 32600 : 32700) + zone;
}

bool is_known_epsg(int epsg) {
  const GdalMessages quiet;
  return system_of(epsg).has_value();
}

bool is_geographic_epsg(int epsg) {
  const GdalMessages quiet;
  const auto system = system_of(epsg);
  return system && system->IsGeographic();
}

bool is_in_area_of_use(int epsg, double latitude_deg, double longitude_deg, double margin_deg) {
  const GdalMessages quiet;
  const auto system = system_of(epsg);
  double west = 0.0, south = 0.0, east = 0.0, north = 0.0;
  if (!system || !system->GetAreaOfUse(&west, &south, &east, &north, nullptr) || west > east) return true;  // across the date line: not asked
  return latitude_deg >= south - margin_deg && latitude_deg <= north + margin_deg && longitude_deg >= west - margin_deg && longitude_deg <= east + margin_deg;
}

std::optional<double> metres_per_unit_of_epsg(int epsg) {
  const GdalMessages quiet;
  const auto system = system_of(epsg);
  if (!system || !system->IsProjected()) return std::nullopt;
  return system->GetLinearUnits();
}

std::string crs_name(int epsg) {
  const GdalMessages quiet;
  const auto system = system_of(epsg);
  const char* name = system ? system->GetName() : nullptr;
  return name != nullptr ? name : "EPSG:" + std::to_string(epsg);
}

std::string crs_wkt(int epsg) {
  const GdalMessages quiet;
  const auto system = system_of(epsg);
  if (!system) return {};
  char* text = nullptr;
  system->exportToWkt(&text);
  const std::string wkt = text != nullptr ? text : "";
  CPLFree(text);
  return wkt;
}

}  // namespace stemwise
