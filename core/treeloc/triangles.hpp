#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/treeloc/near_origins.hpp"
#include "core/treeloc/scene.hpp"
#include "core/treeloc/step_settings.hpp"
#include "core/treeloc/triangle_batch.hpp"

namespace stemwise::treeloc {

/// One triangle. Its vertices are ordered by the side opposite (shortest first), so that matched triangles correspond
/// vertex to vertex. Its own frame: origin at the centroid, x along its longest side, from vertex 0 to vertex 1.
struct Triangle {
  std::uint32_t key = 0;
  TriangleOrigin origin;  ///< the scene's origin in the triangle's own frame
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
  /// A set of trees.
  using TreeSet = std::array<std::uint64_t, 4>;

  void measure_distances();
  void find_neighbours();
  void add_triangles_of(std::size_t center);
  TreeSet partners(std::size_t center, std::size_t other) const;
  void append(const TriangleBatch& batch);

  TriangleSettings settings_;
  TriangleKeys keys_;
  std::size_t tree_count_ = 0;
  std::size_t words_ = 0;  ///< of a TreeSet that are in use
  std::vector<float> x_, y_;
  std::vector<std::uint8_t> dbh_cm_;
  std::vector<float> distance_;         ///< tree_count_ squared; to itself infinite
  std::vector<TreeSet> neighbours_;     ///< per tree: its nearest ones
  std::vector<TreeSet> neighbour_of_;   ///< per tree: those that have it among their nearest ones
  TriangleBatch batch_;
  std::vector<Triangle> triangles_;
};

}  // namespace stemwise::treeloc
