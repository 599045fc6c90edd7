#include "core/survey/fuse_tree.hpp"

#include <algorithm>
#include <cmath>

namespace stemwise {
namespace {

struct Chosen {
  std::optional<double> dbh_m;
  InventoryId source;
};

Chosen mean_dbh(const std::vector<const Sighting*>& measured) {
  double sum = 0.0;
  for (const Sighting* s : measured) sum += *s->stem->dbh_m;
  // A mean of several comes from no one survey.
  return {sum / static_cast<double>(measured.size()), measured.size() == 1 ? measured.front()->ref.inventory : InventoryId{}};
}

Chosen choose_dbh(std::span<const Sighting> sightings, FusionPolicy policy) {
  std::vector<const Sighting*> measured;
  for (const Sighting& s : sightings)
    if (s.stem->dbh_m) measured.push_back(&s);
  if (measured.empty()) return {};
  if (policy == FusionPolicy::mean) return mean_dbh(measured);
  const auto rank = [policy](const Sighting* s) {
    if (policy == FusionPolicy::min_dbh) return -*s->stem->dbh_m;
    return policy == FusionPolicy::best ? s->stem->score * std::sqrt(static_cast<double>(s->stem->times_seen)) : 0.0;
  };
  const Sighting* best = measured.front();
  for (const Sighting* s : measured)  // of equals the newest; for `newest` all are equal
    if (rank(s) > rank(best) || (rank(s) == rank(best) && policy != FusionPolicy::min_dbh)) best = s;
  return {best->stem->dbh_m, best->ref.inventory};
}

void fuse_position(TreeRow& row, std::span<const Sighting> sightings) {
  double weight_sum = 0.0, z_weight_sum = 0.0;
  Eigen::Vector3d axis_sum = Eigen::Vector3d::Zero();
  for (const Sighting& s : sightings) {
    const double weight = 1.0 / (s.position_sd_m * s.position_sd_m);
    row.position_m.head<2>() += weight * s.position_m.head<2>();
    weight_sum += weight;
    if (s.stem->z_m) {
      row.position_m.z() += weight * s.position_m.z();
      z_weight_sum += weight;
    }
    if (s.axis) axis_sum += (s.axis->z() < 0.0 ? -1.0 : 1.0) * *s.axis;
  }
  row.position_m.head<2>() /= weight_sum;
  row.has_z = z_weight_sum > 0.0;
  if (row.has_z) row.position_m.z() /= z_weight_sum;
  row.position_sd_m = 1.0 / std::sqrt(weight_sum);
  if (axis_sum.norm() > 1e-9) row.axis = axis_sum.normalized();
}

}  // namespace

TreeRow fuse_tree(TreeId id, std::span<const Sighting> sightings, FusionPolicy policy) {
  TreeRow row;
  row.tree = id;
  row.times_seen = static_cast<int>(sightings.size());
  if (sightings.empty()) return row;
  fuse_position(row, sightings);
  const Chosen chosen = choose_dbh(sightings, policy);
  row.dbh_m = chosen.dbh_m;
  row.dbh_source = chosen.source;
  row.first_seen = sightings.front().ref.inventory;
  row.last_seen = sightings.back().ref.inventory;
  for (const Sighting& s : sightings)
    if (!s.stem->species.empty()) row.species = s.stem->species;
  return row;
}

}  // namespace stemwise
