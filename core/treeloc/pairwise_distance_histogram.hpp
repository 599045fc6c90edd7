#pragma once
#include <string>
#include <vector>

#include "core/treeloc/scene.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

std::vector<float> pairwise_distance_histogram(const Scene& scene, const PdhSettings& settings);

}  // namespace stemwise::treeloc
