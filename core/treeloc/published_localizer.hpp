#pragma once
#include <memory>

#include "core/treeloc/localizer.hpp"

namespace stemwise::treeloc {

/// TreeLoc++ as published (method.md, sections 2 to 8): histograms, triangle hashes, DBH and yaw outlier rejection, six
/// degrees of freedom, overlap score. With the settings of `Method::treeloc`, its predecessor.
std::unique_ptr<Localizer> make_published_localizer(const Settings& settings);

}  // namespace stemwise::treeloc
