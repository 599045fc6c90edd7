#include "core/project/change_reference.hpp"

#include <cmath>
#include <stdexcept>

namespace stemwise {
namespace {

/// Sums of angles that are zero but for rounding.
double cleaned(double angle_deg) { return std::abs(angle_deg) < 1e-9 ? 0.0 : angle_deg; }

}  // namespace

std::optional<Georeference> moved(const Georeference& georeference, const RigidTransform& reference_from_new) {
  if (georeference.kind == GeoreferenceKind::none) return georeference;
  if (georeference.kind == GeoreferenceKind::crs) return std::nullopt;
  Georeference there = georeference;
  there.anchored_point_m = reference_from_new.inverse() * georeference.anchored_point_m;
  const RollPitchYaw angles = roll_pitch_yaw(enu_from_reference(georeference) * reference_from_new.rotation);
  there.azimuth_deg = std::fmod(-degrees(angles.yaw_rad) + 720.0, 360.0);
  there.roll_deg = cleaned(degrees(angles.roll_rad));
  there.pitch_deg = cleaned(degrees(angles.pitch_rad));
  return there;
}

void change_reference(ProjectState& state, InventoryId id) {
  if (id == state.reference) return;
  if (!state.is_placed(id)) throw std::logic_error("an inventory without a place cannot become the reference of what is aligned");
  const RigidTransform reference_from_new = state.reference_from_inventory(id), new_from_reference = reference_from_new.inverse();
  InventoryAlignment of_old = state.alignments.at(id);  // the two lie on each other as before, told from the other side
  of_old.inventory = state.reference;
  of_old.reference_from_inventory = new_from_reference;
  if (of_old.second_best_pose) of_old.second_best_pose = of_old.second_best_pose->inverse();
  state.alignments.erase(id);
  if (auto own = state.alignments.extract(state.reference)) {  // what is said of the reference itself is said of the new one
    own.mapped().inventory = id;
    own.key() = id;
    state.alignments.insert(std::move(own));
  }
  for (auto& [other, alignment] : state.alignments) {
    if (other == id) continue;
    alignment.reference_from_inventory = new_from_reference * alignment.reference_from_inventory;
    if (alignment.second_best_pose) alignment.second_best_pose = new_from_reference * *alignment.second_best_pose;
  }
  state.alignments[state.reference] = std::move(of_old);
  state.georeference = moved(state.georeference, reference_from_new).value_or(Georeference{});
  state.reference = id;
}

}  // namespace stemwise
