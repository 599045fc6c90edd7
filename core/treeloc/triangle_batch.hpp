#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace stemwise::treeloc {

/// Triangles side by side, so that what is computed for each is computed for several at once by the compiler's vector code
/// (no fused multiply-add, no reordered sums: the same numbers at any vector width). A quantity of all triangles is an array at
/// a fixed place, so that one register finds them all.
class TriangleBatch {
public:
  static constexpr std::size_t most_neighbours = 60;
  static constexpr std::size_t most = most_neighbours * (most_neighbours - 1) / 2;
  struct Tree {
    float x, y;
    std::int32_t number;
  };
  /// One triangle: its vertices in order of the side opposite, shortest first (equals: in the order given), and what follows.
  struct Made {
    std::int32_t trees;             ///< the three numbers, 8 bits each, the first lowest
    std::int32_t steps[3], area;    ///< sides and area in steps, rounded down
    std::int32_t left_handed;       ///< 0 or 1
    std::int32_t origin_x_cm, origin_y_cm, yaw;
    bool within;  ///< the sides are neither too short nor too long
  };
  /// No triangle, but room for `most` around `center`.
  void clear(const Tree& center) {
    center_ = center;
    count_ = 0;
  }
  /// Adds center, `b` and `c`; lengths in metres.
  void add(const Tree& b, const Tree& c, float b_to_c, float center_to_c, float center_to_b) {
    b_x_[count_] = b.x;
    b_y_[count_] = b.y;
    b_number_[count_] = b.number;
    c_x_[count_] = c.x;
    c_y_[count_] = c.y;
    c_number_[count_] = c.number;
    opposite_center_[count_] = b_to_c;
    opposite_b_[count_] = center_to_c;
    opposite_c_[count_++] = center_to_b;
  }
  void compute(float steps_per_m, float min_side_m, float max_side_m);
  std::size_t size() const { return count_; }
  Made made(std::size_t i) const {
    return {trees_[i],       {steps_0_[i], steps_1_[i], steps_2_[i]}, area_[i], left_handed_[i], origin_x_cm_[i],
            origin_y_cm_[i], yaw_[i],                                 within_[i] != 0};
  }

private:
  Tree center_{};
  std::size_t count_ = 0;
  std::array<float, most> b_x_, b_y_, c_x_, c_y_, opposite_center_, opposite_b_, opposite_c_;
  std::array<std::int32_t, most> b_number_, c_number_;
  std::array<std::int32_t, most> trees_, steps_0_, steps_1_, steps_2_, area_, left_handed_, origin_x_cm_, origin_y_cm_, yaw_, within_;
};

}  // namespace stemwise::treeloc
