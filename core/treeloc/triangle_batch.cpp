#include "core/treeloc/triangle_batch.hpp"

#include <cmath>
#include <numbers>

#include "core/base/wide_vectors.hpp"

namespace stemwise::treeloc {
namespace {

/// To the nearest whole number; for |v| < 32000 (std::lround is a call, and there are three per triangle).
std::int32_t rounded(float v) { return static_cast<std::int32_t>(v + 32768.5F) - 32768; }

std::int32_t centimetres(float metres) {
  const float cm = metres * 100.0F;
  const float above = cm < -32000.0F ? -32000.0F : cm;
  return rounded(above > 32000.0F ? 32000.0F : above);
}

/// Angle of (x, y) in 256ths of a turn, rounded. The polynomial is within 0.1 degrees; a step is 1.4. Every branch is
/// computed and one chosen, which vector code can do.
std::int32_t turn_of(float x, float y) {
  const float ax = std::abs(x), ay = std::abs(y);
  const float small = ay < ax ? ay : ax, large = ay < ax ? ax : ay;
  const float ratio = small / (large < 1e-9F ? 1e-9F : large);
  const float sq = ratio * ratio;
  const float flat = ((-0.0464964749F * sq + 0.15931422F) * sq - 0.327622764F) * sq * ratio + ratio;
  const float steep = std::numbers::pi_v<float> / 2 - flat;
  const float right = ay > ax ? steep : flat;
  const float left = std::numbers::pi_v<float> - right;
  const float up = x < 0.0F ? left : right;
  const float down = -up;
  return rounded((y < 0.0F ? down : up) * (128.0F / std::numbers::pi_v<float>)) & 255;
}

/// A vertex with the side opposite.
struct Vertex {
  float side, x, y;
  std::int32_t number;
};

/// The one with the shorter side first. Which it is cannot be guessed: both are computed and one chosen.
inline void put_in_order(Vertex& a, Vertex& b) {
  const bool swap = b.side < a.side;
  const Vertex first{swap ? b.side : a.side, swap ? b.x : a.x, swap ? b.y : a.y, swap ? b.number : a.number};
  b = {swap ? a.side : b.side, swap ? a.x : b.x, swap ? a.y : b.y, swap ? a.number : b.number};
  a = first;
}

}  // namespace

STEMWISE_WIDE_VECTORS void TriangleBatch::compute(float steps_per_m, float min_side_m, float max_side_m) {
  const Tree center = center_;
  const float *b_x = b_x_.data(), *b_y = b_y_.data(), *c_x = c_x_.data(), *c_y = c_y_.data();
  const float *of_center = opposite_center_.data(), *of_b = opposite_b_.data(), *of_c = opposite_c_.data();
  const std::int32_t *b_number = b_number_.data(), *c_number = c_number_.data();
  std::int32_t *trees = trees_.data(), *steps_0 = steps_0_.data(), *steps_1 = steps_1_.data(), *steps_2 = steps_2_.data(),
               *area = area_.data(), *left_handed = left_handed_.data(), *origin_x = origin_x_cm_.data(),
               *origin_y = origin_y_cm_.data(), *yaw = yaw_.data(), *within = within_.data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < count_; ++i) {
    Vertex v0{of_center[i], center.x, center.y, center.number};
    Vertex v1{of_b[i], b_x[i], b_y[i], b_number[i]};
    Vertex v2{of_c[i], c_x[i], c_y[i], c_number[i]};
    put_in_order(v0, v1);
    put_in_order(v1, v2);
    put_in_order(v0, v1);
    const float ex = v1.x - v0.x, ey = v1.y - v0.y;  // along the longest side
    const float fx = v2.x - v0.x, fy = v2.y - v0.y;
    const float twice_area = ex * fy - ey * fx;
    const float cx = v0.x + (ex + fx) / 3.0F, cy = v0.y + (ey + fy) / 3.0F;
    const float per_length = 1.0F / (v2.side < 1e-9F ? 1e-9F : v2.side);
    const float cosine = ex * per_length, sine = ey * per_length;
    trees[i] = v0.number | v1.number << 8 | v2.number << 16;
    steps_0[i] = static_cast<std::int32_t>(v0.side * steps_per_m);
    steps_1[i] = static_cast<std::int32_t>(v1.side * steps_per_m);
    steps_2[i] = static_cast<std::int32_t>(v2.side * steps_per_m);
    area[i] = static_cast<std::int32_t>(std::abs(twice_area) / 2 * steps_per_m);
    left_handed[i] = twice_area > 0.0F ? 1 : 0;
    origin_x[i] = centimetres(-(cosine * cx + sine * cy));
    origin_y[i] = centimetres(sine * cx - cosine * cy);
    yaw[i] = turn_of(ex, ey);
    within[i] = (v0.side >= min_side_m ? 1 : 0) & (v2.side <= max_side_m ? 1 : 0);
  }
}

}  // namespace stemwise::treeloc
