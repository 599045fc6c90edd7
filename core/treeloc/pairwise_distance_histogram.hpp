#pragma once
#include <string>
#include <vector>

#include "core/base/field.hpp"
#include "core/treeloc/scene.hpp"

namespace stemwise::treeloc {

/// PDH (method.md, section 4): distances between the reconstructed trees, whatever the origin.
struct PdhSettings {
  bool enabled = true;
  double longest_m = 10.0;
  int bins = 40;
  Fields fields(const std::string& prefix);
};

std::vector<float> pairwise_distance_histogram(const Scene& scene, const PdhSettings& settings);

}  // namespace stemwise::treeloc
