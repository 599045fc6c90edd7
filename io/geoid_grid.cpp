#include "io/geoid_grid.hpp"

#include <ogr_spatialref.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "core/geodesy/azimuth.hpp"
#include "core/geometry/rigid_transform.hpp"
#include "io/crs.hpp"
#include "io/gdal_session.hpp"

namespace stemwise {
namespace {

struct DeleteTransformation {
  void operator()(OGRCoordinateTransformation* t) const { OGRCoordinateTransformation::DestroyCT(t); }
};
using Transformation = std::unique_ptr<OGRCoordinateTransformation, DeleteTransformation>;

Transformation open_grid(const std::string& file) {
  OGRCoordinateTransformationOptions options;
  const std::string pipeline = "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=vgridshift +grids=" + file +
                               " +multiplier=1 +step +proj=unitconvert +xy_in=rad +xy_out=deg";
  options.SetCoordinateOperation(pipeline.c_str(), false);
  return Transformation(OGRCreateCoordinateTransformation(nullptr, nullptr, options));
}

std::optional<double> geoid_at(OGRCoordinateTransformation& grid, const Geodetic& at) {
  double x = at.longitude_deg, y = at.latitude_deg, z = 0.0;
  if (!grid.Transform(1, &x, &y, &z) || !std::isfinite(z)) return std::nullopt;
  return z;
}

}  // namespace

bool is_geoid_grid(const std::string& name) {
  const std::string suffix = std::filesystem::path(name).extension().string();
  return suffix == ".gtx" || suffix == ".tif" || suffix == ".tiff" || suffix == ".gsb";
}

Result<LocalGeoid> local_geoid_of_grid(const std::string& file, const Geodetic& origin) {
  const GdalMessages messages;
  const Transformation grid = open_grid(file);
  const auto refuse = [&](const std::string& text) {
    return Result<LocalGeoid>::failure(Issue{Severity::error, file, 0, "", text + (messages.errors().empty() ? "" : ": " + messages.last_error()),
                                             "name a grid that PROJ has (projsync fetches them), or the path of one"});
  };
  if (!grid) return refuse("is no geoid grid that PROJ can read");
  const auto at = geoid_at(*grid, origin);
  const auto east = geoid_at(*grid, beside(origin, geoid_step_m, 0.0)), north = geoid_at(*grid, beside(origin, 0.0, geoid_step_m));
  if (!at || !east || !north) return refuse("this geoid grid is not there, or does not cover the project");
  return local_geoid(std::filesystem::path(file).filename().string(), *at, *east, *north);
}

std::optional<double> grid_convergence_deg(int epsg, const Geodetic& point) {
  const auto to_grid = CrsTransform::between(wgs84_epsg, epsg);
  if (!to_grid || is_geographic_epsg(epsg)) return std::nullopt;
  const Geodetic north = beside(point, 0.0, 100.0);
  const auto a = (*to_grid.value)({point.longitude_deg, point.latitude_deg, 0.0}), b = (*to_grid.value)({north.longitude_deg, north.latitude_deg, 0.0});
  if (!a || !b) return std::nullopt;
  // True north lies at this bearing on the grid; grid north at the opposite one from true north.
  return -degrees(std::atan2(b->x() - a->x(), b->y() - a->y()));
}

}  // namespace stemwise
