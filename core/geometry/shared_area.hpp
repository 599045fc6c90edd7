#pragma once
#include "core/geometry/polygon.hpp"

namespace stemwise {

/// Area inside both simple polygons, by scan lines (at least 2,000 over the height they share: a relative error well under
/// 0.1 % for footprints). 0 where they do not meet or one is empty.
double shared_area_sq_m(const Polygon& a, const Polygon& b);

}  // namespace stemwise
