#include "core/survey/place_survey.hpp"

#include <cmath>

namespace stemwise {

PlacedSurvey place_survey(const Inventory& inventory, const RigidTransform& reference_from_inventory, const Eigen::Vector2d& origin_m, double noise_m) {
  NodeList nodes;
  nodes.origin_m = origin_m;
  std::vector<std::size_t> stem_of;
  for (std::size_t i = 0; i < inventory.stems.size(); ++i) {
    const Stem& stem = inventory.stems[i];
    if (!std::isfinite(stem.x_m) || !std::isfinite(stem.y_m)) continue;
    const Eigen::Vector3d p = reference_from_inventory * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
    const auto dbh_m = stem.dbh_for_matching_m();
    nodes.at_m.emplace_back(p.x() - origin_m.x(), p.y() - origin_m.y());
    nodes.dbh_cm.push_back(dbh_m && std::isfinite(*dbh_m) && *dbh_m > 0.0 ? 100.0 * *dbh_m : -1.0);
    nodes.members.push_back({i});
    stem_of.push_back(i);
  }
  return {&inventory, IndexedList(std::move(nodes)), std::move(stem_of), noise_m};
}

std::vector<Stem> moved_stems(const Inventory& inventory, const RigidTransform& to_from_inventory) {
  std::vector<Stem> stems = inventory.stems;
  for (Stem& stem : stems) {
    const Eigen::Vector3d p = to_from_inventory * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
    stem.x_m = p.x(), stem.y_m = p.y();
    if (stem.z_m) stem.z_m = p.z();
    if (stem.axis) stem.axis = to_from_inventory.rotation * *stem.axis;
  }
  return stems;
}

}  // namespace stemwise
