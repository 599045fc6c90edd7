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
  double sum = 0.0, weights = 0.0;
  for (const Sighting* s : measured) {
    const double weight = 1.0 / std::max(1e-12, s->dbh_error_m * s->dbh_error_m);
    sum += weight * *s->stem->dbh_m;
    weights += weight;
  }
  // A mean of several comes from no one survey.
  return {sum / weights, measured.size() == 1 ? measured.front()->ref.inventory : InventoryId{}};
}

/// One over the error to be expected of this diameter: the survey's own, larger for a stem that was seen badly, smaller for
/// one seen in many frames.
double quality(const Sighting& s) {
  const double seen = std::max(0.05, s.stem->score) * std::sqrt(static_cast<double>(std::max(1, s.stem->times_seen)));
  return seen / std::max(1e-6, s.dbh_error_m);
}

const Sighting* sighting_of(std::span<const Sighting> sightings, std::optional<InventoryId> survey) {
  for (const Sighting& s : sightings)
    if (survey && s.ref.inventory == *survey) return &s;
  return nullptr;
}

Chosen choose_dbh(std::span<const Sighting> sightings, FusionPolicy policy, std::optional<InventoryId> by_hand) {
  if (const Sighting* chosen = sighting_of(sightings, by_hand); chosen != nullptr && chosen->stem->dbh_m) return {chosen->stem->dbh_m, chosen->ref.inventory};
  std::vector<const Sighting*> measured;
  for (const Sighting& s : sightings)
    if (s.stem->dbh_m) measured.push_back(&s);
  if (measured.empty()) return {};
  if (policy == FusionPolicy::mean) return mean_dbh(measured);
  const auto rank = [policy](const Sighting* s) {
    if (policy == FusionPolicy::min_dbh) return -*s->stem->dbh_m;
    return policy == FusionPolicy::best ? quality(*s) : 0.0;
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

TreeRow fuse_tree(TreeId id, std::span<const Sighting> sightings, FusionPolicy policy, const FusionChoice& choice) {
  TreeRow row;
  row.tree = id;
  row.times_seen = static_cast<int>(sightings.size());
  if (sightings.empty()) return row;
  const Sighting* place = sighting_of(sightings, choice.position);
  fuse_position(row, place != nullptr ? std::span(place, 1) : sightings);
  const Chosen chosen = choose_dbh(sightings, policy, choice.dbh);
  row.dbh_m = chosen.dbh_m;
  row.dbh_source = chosen.source;
  row.first_seen = sightings.front().ref.inventory;
  row.last_seen = sightings.back().ref.inventory;
  for (const Sighting& s : sightings)
    if (!s.stem->species.empty()) row.species = s.stem->species;
  if (const Sighting* s = sighting_of(sightings, choice.species); s != nullptr && !s->stem->species.empty()) row.species = s->stem->species;
  return row;
}

}  // namespace stemwise
