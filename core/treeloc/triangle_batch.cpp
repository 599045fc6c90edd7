#include "core/treeloc/triangle_batch.hpp"

#include <cmath>
#include <numbers>

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

}  // namespace

void TriangleBatch::clear(std::size_t most) {
  count_ = 0;
  if (yaw_.size() >= most + 1) return;
  for (int c = 0; c < 3; ++c) {
    side_[c].resize(most + 1);
    x_[c].resize(most + 1);
    y_[c].resize(most + 1);
    tree_[c].resize(most + 1);
    side_steps_[c].resize(most + 1);
  }
  for (auto* column : {&area_steps_, &left_handed_, &origin_x_cm_, &origin_y_cm_, &yaw_}) column->resize(most + 1);
}

void TriangleBatch::add(const Corner& a, const Corner& b, const Corner& c, float min_side, float max_side) {
  // Which is longer cannot be guessed: places are counted instead of jumping.
  const int b_before_a = b.side < a.side ? 1 : 0, c_before_a = c.side < a.side ? 1 : 0, c_before_b = c.side < b.side ? 1 : 0;
  const auto put = [this](int place, const Corner& corner) {
    side_[place][count_] = corner.side;
    x_[place][count_] = corner.x;
    y_[place][count_] = corner.y;
    tree_[place][count_] = corner.tree;
  };
  put(b_before_a + c_before_a, a);
  put(1 - b_before_a + c_before_b, b);
  put(2 - c_before_a - c_before_b, c);
  count_ += side_[0][count_] >= min_side && side_[2][count_] <= max_side ? 1 : 0;
}

void TriangleBatch::compute(float steps_per_m) {
  const float *x0 = x_[0].data(), *x1 = x_[1].data(), *x2 = x_[2].data();
  const float *y0 = y_[0].data(), *y1 = y_[1].data(), *y2 = y_[2].data();
  const float* longest = side_[2].data();
  std::int32_t *area = area_steps_.data(), *left = left_handed_.data(), *origin_x = origin_x_cm_.data(),
               *origin_y = origin_y_cm_.data(), *yaw = yaw_.data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < count_; ++i) {
    const float ex = x1[i] - x0[i], ey = y1[i] - y0[i];  // along the longest side
    const float fx = x2[i] - x0[i], fy = y2[i] - y0[i];
    const float twice_area = ex * fy - ey * fx;
    const float cx = x0[i] + (ex + fx) / 3.0F, cy = y0[i] + (ey + fy) / 3.0F;
    const float per_length = 1.0F / (longest[i] < 1e-9F ? 1e-9F : longest[i]);
    const float cosine = ex * per_length, sine = ey * per_length;
    area[i] = static_cast<std::int32_t>(std::abs(twice_area) / 2 * steps_per_m);
    left[i] = twice_area > 0.0F ? 1 : 0;
    origin_x[i] = centimetres(-(cosine * cx + sine * cy));
    origin_y[i] = centimetres(sine * cx - cosine * cy);
    yaw[i] = turn_of(ex, ey);
  }
  for (int c = 0; c < 3; ++c) {
    const float* side = side_[c].data();
    std::int32_t* steps = side_steps_[c].data();
#pragma GCC ivdep
    for (std::size_t i = 0; i < count_; ++i) steps[i] = static_cast<std::int32_t>(side[i] * steps_per_m);
  }
}

}  // namespace stemwise::treeloc
