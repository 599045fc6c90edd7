#pragma once
#include <cstdint>
#include <vector>

namespace stemwise::treeloc {

/// Triangles side by side, so that what is computed for each is computed for several at once by the compiler's vector code
/// (no fused multiply-add, no reordered sums: the same numbers at any vector width). Buffers are kept.
class TriangleBatch {
public:
  /// A corner with the side opposite.
  struct Corner {
    float side, x, y;
    std::uint8_t tree;
  };
  /// Room for so many triangles, none of them there yet.
  void clear(std::size_t most);
  /// Adds one unless its shortest side is below `min_side` or its longest above `max_side`. Corners are put in order of the
  /// side opposite, shortest first; among equals the given order stays.
  void add(const Corner& a, const Corner& b, const Corner& c, float min_side, float max_side);
  std::size_t size() const { return count_; }

  /// Fills in what follows from the corners.
  void compute(float steps_per_m);

  std::uint8_t tree(int corner, std::size_t i) const { return tree_[corner][i]; }
  std::int32_t side_steps(int corner, std::size_t i) const { return side_steps_[corner][i]; }
  std::int32_t area_steps(std::size_t i) const { return area_steps_[i]; }
  bool left_handed(std::size_t i) const { return left_handed_[i] != 0; }
  std::int16_t origin_x_cm(std::size_t i) const { return static_cast<std::int16_t>(origin_x_cm_[i]); }
  std::int16_t origin_y_cm(std::size_t i) const { return static_cast<std::int16_t>(origin_y_cm_[i]); }
  std::uint8_t yaw(std::size_t i) const { return static_cast<std::uint8_t>(yaw_[i]); }

private:
  std::size_t count_ = 0;
  std::vector<float> side_[3], x_[3], y_[3];
  std::vector<std::uint8_t> tree_[3];
  std::vector<std::int32_t> side_steps_[3], area_steps_, left_handed_, origin_x_cm_, origin_y_cm_, yaw_;
};

}  // namespace stemwise::treeloc
