#include "io/earth_frame.hpp"

#include "io/crs.hpp"

namespace stemwise {

struct EarthFrame::Impl {
  Georeference georeference;
  std::optional<int> epsg;
  std::optional<CrsTransform> target_from_source;  ///< source: WGS 84 for an anchor, the georeference's CRS for `crs`
  std::optional<CrsTransform> wgs84_from_source;   ///< for `crs`
};

EarthFrame::EarthFrame(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EarthFrame::EarthFrame(EarthFrame&&) noexcept = default;
EarthFrame& EarthFrame::operator=(EarthFrame&&) noexcept = default;
EarthFrame::~EarthFrame() = default;

Result<EarthFrame> EarthFrame::of(const Georeference& georeference, std::optional<int> target_epsg) {
  auto impl = std::make_unique<Impl>();
  impl->georeference = georeference;
  if (georeference.kind == GeoreferenceKind::none) {
    if (target_epsg) {
      return Result<EarthFrame>::failure(Issue{Severity::error, {}, 0, {}, "the project has no georeference, so its coordinates cannot be given in EPSG:" + std::to_string(*target_epsg),
                                               "give it an anchor, control points or a CRS first (stemwise georeference)"});
    }
  } else {
    const bool anchored = georeference.kind == GeoreferenceKind::anchor;
    const int own = anchored ? utm_epsg_of(georeference.origin.longitude_deg, georeference.origin.latitude_deg) : georeference.epsg;
    const int source = anchored ? wgs84_epsg : georeference.epsg;
    impl->epsg = target_epsg.value_or(own);
    auto target = CrsTransform::between(source, *impl->epsg);
    auto wgs84 = CrsTransform::between(source, wgs84_epsg);
    if (!target) return Result<EarthFrame>::failure(target.issues);
    if (!wgs84) return Result<EarthFrame>::failure(wgs84.issues);
    impl->target_from_source = std::move(*target.value);
    impl->wgs84_from_source = std::move(*wgs84.value);
  }
  Result<EarthFrame> result;
  result.value.emplace(EarthFrame(std::move(impl)));
  return result;
}

std::optional<int> EarthFrame::epsg() const { return impl_->epsg; }

std::optional<Eigen::Vector3d> EarthFrame::target_from_reference(const Eigen::Vector3d& point_m) const {
  switch (impl_->georeference.kind) {
    case GeoreferenceKind::none: return point_m;
    case GeoreferenceKind::crs: return (*impl_->target_from_source)(point_m);
    case GeoreferenceKind::anchor: break;
  }
  const Geodetic g = stemwise::geodetic_from_reference(impl_->georeference, point_m);
  return (*impl_->target_from_source)({g.longitude_deg, g.latitude_deg, g.height_m - geoid_height_m(impl_->georeference, g)});
}

std::optional<Geodetic> EarthFrame::geodetic_from_reference(const Eigen::Vector3d& point_m) const {
  switch (impl_->georeference.kind) {
    case GeoreferenceKind::none: return std::nullopt;
    case GeoreferenceKind::anchor: return stemwise::geodetic_from_reference(impl_->georeference, point_m);
    case GeoreferenceKind::crs: break;
  }
  const auto p = (*impl_->wgs84_from_source)(point_m);
  if (!p) return std::nullopt;
  Geodetic g{p->y(), p->x(), p->z()};
  g.height_m += geoid_height_m(impl_->georeference, g);
  return g;
}

double EarthFrame::given_height_m(const Geodetic& point) const { return point.height_m - geoid_height_m(impl_->georeference, point); }
std::string EarthFrame::height_datum() const {
  const std::string& geoid = impl_->georeference.geoid.name;
  return geoid.empty() ? "the ellipsoid" : "the geoid " + geoid;
}
double EarthFrame::position_sd_m(const Eigen::Vector3d& point_m, double sd_in_reference_m) const {
  return position_sd_on_earth_m(impl_->georeference, point_m, sd_in_reference_m);
}

}  // namespace stemwise
