#pragma once
#include <string>
#include <vector>

#include "core/treeloc/scene.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// radial_bins x dbh_bins raw counts, row by row, after a 2x2 uniform smoothing.
std::vector<float> tree_distribution_histogram(const Scene& scene, const TdhSettings& settings);

}  // namespace stemwise::treeloc
