#include "io/underlay/file_placement.hpp"

#include <ogr_spatialref.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "io/crs.hpp"
#include "io/gdal_session.hpp"

namespace stemwise {
namespace {

struct DeleteTransformation {
  void operator()(OGRCoordinateTransformation* t) const { OGRCoordinateTransformation::DestroyCT(t); }
};
using Transformation = std::unique_ptr<OGRCoordinateTransformation, DeleteTransformation>;

constexpr int steps_per_edge = 8;
constexpr double metres_per_degree = 111'320.0;

Issue no_georeference(const std::string& path, const std::string& system) {
  return {Severity::error, path, 0, {}, "the file is in " + system + ", but the project does not know where it lies on the earth",
          "georeference the project first (step 4), or save the file without its coordinate system if its coordinates are those of the stems"};
}

std::optional<Eigen::Vector3d> transformed(OGRCoordinateTransformation& way, Eigen::Vector3d p) {
  const GdalMessages quiet;
  if (!way.Transform(1, &p.x(), &p.y()) || !std::isfinite(p.x()) || !std::isfinite(p.y())) return std::nullopt;
  return p;
}

}  // namespace

struct FilePlacement::Impl {
  UnderlayRequest request;
  bool has_system = false;
  OGRSpatialReference file_system;    ///< horizontal
  double metres_per_height_unit = 1.0;
  Transformation earth_from_file, file_from_earth;  ///< earth: WGS 84 for an anchor, the georeference's CRS else
};

FilePlacement::FilePlacement(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FilePlacement::FilePlacement(FilePlacement&&) noexcept = default;
FilePlacement& FilePlacement::operator=(FilePlacement&&) noexcept = default;
FilePlacement::~FilePlacement() = default;

Result<FilePlacement> FilePlacement::of(const std::string& wkt, const UnderlayRequest& request) {
  const GdalMessages messages;
  auto impl = std::make_unique<Impl>();
  impl->request = request;
  const auto refuse = [](Issue issue) { return Result<FilePlacement>::failure(std::move(issue)); };
  if (!wkt.empty()) {
    impl->has_system = true;
    if (impl->file_system.SetFromUserInput(wkt.c_str()) != OGRERR_NONE)
      return refuse({Severity::error, request.path, 0, {}, "its coordinate system cannot be understood", "save it with an EPSG code from a GIS"});
    impl->file_system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (impl->file_system.IsCompound()) {
      impl->metres_per_height_unit = impl->file_system.GetTargetLinearUnits("VERT_CS");
      impl->file_system.StripVertical();
    }
    const std::string name = impl->file_system.GetName() ? impl->file_system.GetName() : "a coordinate system";
    if (request.georeference.kind == GeoreferenceKind::none) return refuse(no_georeference(request.path, name));
    OGRSpatialReference earth;
    const int epsg = request.georeference.kind == GeoreferenceKind::anchor ? wgs84_epsg : request.georeference.epsg;
    const bool is_known = earth.importFromEPSG(epsg) == OGRERR_NONE;
    earth.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (is_known) {
      impl->earth_from_file.reset(OGRCreateCoordinateTransformation(&impl->file_system, &earth));
      impl->file_from_earth.reset(OGRCreateCoordinateTransformation(&earth, &impl->file_system));
    }
    if (!impl->earth_from_file || !impl->file_from_earth)
      return refuse({Severity::error, request.path, 0, {}, "no way leads from " + name + " to EPSG:" + std::to_string(epsg), "save it in the project's coordinate system"});
  }
  Result<FilePlacement> result;
  result.value.emplace(FilePlacement(std::move(impl)));
  return result;
}

std::optional<Eigen::Vector3d> FilePlacement::reference_from_file(const Eigen::Vector3d& point) const {
  const Impl& s = *impl_;
  if (!s.has_system) return s.request.reference_from_local * point;
  const auto earth = transformed(*s.earth_from_file, point);
  if (!earth || s.request.georeference.kind == GeoreferenceKind::crs) return earth;
  Geodetic g{earth->y(), earth->x(), point.z()};
  g.height_m += geoid_height_m(s.request.georeference, g);
  return reference_from_geodetic(s.request.georeference, g);
}

std::optional<Eigen::Vector3d> FilePlacement::file_from_reference(const Eigen::Vector3d& point_m) const {
  const Impl& s = *impl_;
  if (!s.has_system) return s.request.reference_from_local.inverse() * point_m;
  if (s.request.georeference.kind == GeoreferenceKind::crs) return transformed(*s.file_from_earth, point_m);
  const Geodetic g = geodetic_from_reference(s.request.georeference, point_m);
  return transformed(*s.file_from_earth, {g.longitude_deg, g.latitude_deg, g.height_m - geoid_height_m(s.request.georeference, g)});
}

Eigen::AlignedBox2d FilePlacement::area_in_file() const {
  const Eigen::AlignedBox2d& area = impl_->request.area_in_reference_m;
  Eigen::AlignedBox2d box;
  for (int i = 0; i <= steps_per_edge; ++i)
    for (int j = 0; j <= steps_per_edge; ++j) {
      const Eigen::Vector2d share(static_cast<double>(i) / steps_per_edge, static_cast<double>(j) / steps_per_edge);
      const Eigen::Vector2d p = area.min() + area.sizes().cwiseProduct(share);
      if (const auto there = file_from_reference({p.x(), p.y(), 0.0})) box.extend(there->head<2>());
    }
  return box;
}

Eigen::Vector3d FilePlacement::metres_per_unit() const {
  const Impl& s = *impl_;
  if (!s.has_system) return Eigen::Vector3d::Ones();
  if (s.file_system.IsGeographic()) {
    const Eigen::AlignedBox2d area = area_in_file();
    const double latitude_rad = area.isEmpty() ? 0.0 : area.center().y() * std::numbers::pi / 180.0;
    return {metres_per_degree * std::max(0.01, std::cos(latitude_rad)), metres_per_degree, s.metres_per_height_unit};
  }
  const double unit = s.file_system.GetLinearUnits();
  return {unit, unit, s.metres_per_height_unit};
}

std::string FilePlacement::system() const {
  const char* name = impl_->has_system ? impl_->file_system.GetName() : nullptr;
  return name ? name : "";
}

std::string box_text(const Eigen::AlignedBox2d& box) {
  const int decimals = box.isEmpty() || box.sizes().maxCoeff() > 1.0 ? 1 : 5;
  char text[200];
  std::snprintf(text, sizeof text, "%.*f, %.*f to %.*f, %.*f", decimals, box.min().x(), decimals, box.min().y(), decimals, box.max().x(), decimals, box.max().y());
  return text;
}

Issue elsewhere(const UnderlayRequest& request, const FilePlacement& placement, const Eigen::AlignedBox2d& file_box) {
  const Eigen::AlignedBox2d area = placement.area_in_file();
  std::string text = "it lies away from the stems: its coordinates go from " + box_text(file_box);
  if (!area.isEmpty()) text += ", the stems lie in " + box_text(area) + (placement.system().empty() ? "" : " of " + placement.system());
  return {Severity::error, request.path, 0, {}, std::move(text),
          placement.system().empty() ? "it names no coordinate system and is taken for local coordinates of the reference: give it the system it is in, or move it there"
                                     : "check the project's georeference (step 4), or choose a file that covers the plot"};
}

}  // namespace stemwise
