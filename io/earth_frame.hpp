#pragma once
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/geodesy/georeference.hpp"

namespace stemwise {

/// The way from the reference's frame to a coordinate system on the earth, as a georeference tells it.
class EarthFrame {
 public:
  /// `target_epsg`: none means the georeference's own (the UTM zone of its origin, or its CRS). Without a georeference the
  /// target is the reference's frame itself, unless a system is asked for: that is a failure.
  static Result<EarthFrame> of(const Georeference& georeference, std::optional<int> target_epsg = std::nullopt);
  EarthFrame(EarthFrame&&) noexcept;
  EarthFrame& operator=(EarthFrame&&) noexcept;
  ~EarthFrame();

  /// Of `target_from_reference`'s results; none: local metres.
  std::optional<int> epsg() const;
  bool is_local() const { return !epsg(); }
  /// Heights are above what `height_datum` names. Nothing where the point has no place in the target.
  std::optional<Eigen::Vector3d> target_from_reference(const Eigen::Vector3d& point_m) const;
  /// Height above the ellipsoid. Nothing without a georeference.
  std::optional<Geodetic> geodetic_from_reference(const Eigen::Vector3d& point_m) const;
  /// The height that exports give: above the ellipsoid, or above the geoid where the georeference names one.
  double given_height_m(const Geodetic& point) const;
  std::string height_datum() const;  ///< "the ellipsoid", "the geoid egm2008-5"
  /// Planar, one axis: of the point itself and of the georeference.
  double position_sd_m(const Eigen::Vector3d& point_m, double sd_in_reference_m) const;

 private:
  struct Impl;
  explicit EarthFrame(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace stemwise
