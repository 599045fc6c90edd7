#pragma once
#include <cstdint>
#include <cstdlib>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace stemwise::treeloc {

/// Where a scene's origin lies in the frame of one of its triangles.
struct TriangleOrigin {
  std::int16_t x_cm = 0;
  std::int16_t y_cm = 0;
};

/// So many places are looked at together; an array must be that much longer than what is asked about.
inline constexpr std::uint32_t near_origins_lanes = 8;

/// Bit i says that origins[i], i < 8, lies within the square root of `radius_sq` (cm^2, at most 1e9) of (x, y). Whole numbers
/// only, and SSE2 belongs to every x86-64: the same answer everywhere.
inline unsigned near_origins_mask(const TriangleOrigin* origins, TriangleOrigin at, std::int32_t radius_sq) {
#ifdef __SSE2__
  std::int32_t both;
  static_assert(sizeof both == sizeof at);
  __builtin_memcpy(&both, &at, sizeof both);
  const __m128i center = _mm_set1_epi32(both);
  const __m128i lowest = _mm_set1_epi16(-32767);  // so that two squares do not overflow
  const __m128i beyond = _mm_set1_epi32(radius_sq);
  const auto far = [&](const TriangleOrigin* four) {
    const __m128i difference = _mm_subs_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(four)), center);
    const __m128i bounded = _mm_max_epi16(difference, lowest);
    return _mm_cmpgt_epi32(_mm_madd_epi16(bounded, bounded), beyond);
  };
  const __m128i eight = _mm_packs_epi16(_mm_packs_epi32(far(origins), far(origins + 4)), _mm_setzero_si128());
  return ~static_cast<unsigned>(_mm_movemask_epi8(eight)) & 0xFFU;
#else
  unsigned mask = 0;
  for (unsigned i = 0; i < near_origins_lanes; ++i) {
    const std::int64_t dx = origins[i].x_cm - at.x_cm, dy = origins[i].y_cm - at.y_cm;
    mask |= (dx * dx + dy * dy <= radius_sq ? 1U : 0U) << i;
  }
  return mask;
#endif
}

}  // namespace stemwise::treeloc
