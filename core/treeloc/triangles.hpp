#pragma once
#include <cstdint>
#include <vector>

#include "core/base/field.hpp"
#include "core/treeloc/scene.hpp"

namespace stemwise::treeloc {

/// The triangles of a scene (method.md, section 4): every tree with each pair of its nearest neighbours.
struct TriangleSettings {
  int neighbours = 12;
  double min_side_m = 0.5;
  double max_side_m = 30.0;
  double step_m = 0.15;
  bool area = false;        ///< the published key of eq. 3 with the area
  bool orientation = true;  ///< the triangle's handedness belongs to the key
  Fields fields(const std::string& prefix);
};

/// One triangle. Its vertices are ordered by the side opposite (shortest first), so that matched triangles correspond
/// vertex to vertex. Its own frame: origin at the centroid, x along its longest side, from vertex 0 to vertex 1.
struct Triangle {
  std::uint32_t key = 0;
  std::int16_t origin_x_cm = 0;  ///< the scene's origin in the triangle's own frame
  std::int16_t origin_y_cm = 0;
  std::uint8_t yaw = 0;  ///< of the triangle's frame in the scene, in 256ths of a turn
  std::uint8_t dbh_cm[3] = {0, 0, 0};
  std::uint8_t tree[3] = {0, 0, 0};
};

/// Turns quantised side lengths into keys. Without area the key is the dense rank of (side, side, side, handedness) among
/// all possible triangles, so that it can index an array; with area it is the published hash (eq. 3).
class TriangleKeys {
public:
  explicit TriangleKeys(const TriangleSettings& settings);
  /// Keys lie in [0, count()).
  std::uint32_t count() const { return count_; }
  /// a <= b <= c are the sides in steps, rounded down.
  std::uint32_t key(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t area, bool left_handed) const {
    if (hashed_) return published_hash(a, b, c, area);
    const std::uint32_t dense = row_[c * width_ + b] + a;
    return with_orientation_ ? 2 * dense + (left_handed ? 1U : 0U) : dense;
  }
  static std::uint32_t published_hash(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t area);

private:
  bool hashed_;
  bool with_orientation_;
  std::uint32_t width_;
  std::uint32_t count_;
  std::vector<std::uint32_t> row_;
};

/// Makes the triangles of scenes. Keeps its buffers between scenes: one per thread.
class TriangleMaker {
public:
  explicit TriangleMaker(const TriangleSettings& settings);
  /// Valid until the next call. At most 255 trees of a scene take part.
  const std::vector<Triangle>& make(const Scene& scene);
  const TriangleKeys& keys() const { return keys_; }

private:
  void find_neighbours();
  void add_triangle(std::size_t i, std::size_t j, std::size_t k);
  bool made_by(std::size_t center, std::size_t other, std::size_t another) const;

  TriangleSettings settings_;
  TriangleKeys keys_;
  std::size_t tree_count_ = 0;
  std::vector<float> x_, y_;
  std::vector<std::uint8_t> dbh_cm_;
  std::vector<float> distance_;             ///< tree_count_ squared
  std::vector<std::uint8_t> neighbours_;    ///< per tree, `neighbour_count_` of them
  std::vector<std::uint8_t> is_neighbour_;  ///< tree_count_ squared
  std::size_t neighbour_count_ = 0;
  std::vector<Triangle> triangles_;
};

}  // namespace stemwise::treeloc
