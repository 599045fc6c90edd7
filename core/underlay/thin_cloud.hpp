#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace stemwise {

/// One point as a file has it.
struct RawPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::uint16_t intensity = 0;
  std::uint8_t red = 0, green = 0, blue = 0;
  bool is_ground = false;  ///< a file's own class
};

/// Keeps one point per cube, the first one met. Where more cubes are filled than may be kept the cubes grow, so that memory is
/// bounded whatever is added. The same points in the same order give the same choice.
class CloudThinner {
 public:
  /// `metres_per_unit`: of the coordinates that are added, axis by axis.
  CloudThinner(std::size_t most_points, double finest_spacing_m, const Eigen::Vector3d& metres_per_unit = Eigen::Vector3d::Ones());

  void add(const RawPoint& point);  ///< what is not finite is dropped
  double spacing_m() const { return spacing_m_; }
  const std::vector<RawPoint>& points() const { return points_; }
  std::vector<RawPoint> take() { return std::move(points_); }

 private:
  bool is_new(const Eigen::Vector3d& position);
  void grow();

  std::size_t most_points_;
  double spacing_m_;
  Eigen::Vector3d metres_per_unit_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::vector<RawPoint> points_;
  std::vector<std::uint64_t> slots_;  ///< keys of filled cubes, open addressing; 0: free
};

}  // namespace stemwise
