#include "core/survey/drawn_ground.hpp"

#include <algorithm>

#include "core/geometry/polygon.hpp"

namespace stemwise {

bool is_on_drawn_ground(const Tables& tables, InventoryId survey, const Eigen::Vector3d& position_m) {
  const auto found = std::find_if(tables.coverages.begin(), tables.coverages.end(), [survey](const CoverageRow& row) { return row.inventory == survey; });
  if (found == tables.coverages.end() || found->source != CoverageSource::drawn || found->in_reference.empty()) return true;
  return contains(found->in_reference, position_m.head<2>());
}

}  // namespace stemwise
