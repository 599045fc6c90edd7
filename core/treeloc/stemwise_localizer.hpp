#pragma once
#include <memory>

#include "core/treeloc/localizer.hpp"

namespace stemwise::treeloc {

/// The default method (method.md, section 12): inverted index over triangle keys, ranking by yaw peak, verification by
/// trees, choice by displacement among the strong, propagation to neighbouring scenes, fusion of the poses.
std::unique_ptr<Localizer> make_stemwise_localizer(const Settings& settings);

}  // namespace stemwise::treeloc
