#pragma once
#include "core/project/project_state.hpp"

namespace stemwise {

/// Another placed inventory becomes the reference: the common frame is its own from now on, and everything else keeps its place
/// in it and on the earth. Poses are turned into the new frame; matches, trees, decisions and coverages stay as they are. Only a
/// georeference that says "the reference's coordinates are those of a CRS" cannot be said of another frame: it is taken away.
/// Throws std::logic_error for an inventory without a place.
void change_reference(ProjectState& state, InventoryId id);

/// The same place on the earth for a frame whose pose in the reference's is known. Nothing for `crs`.
std::optional<Georeference> moved(const Georeference& georeference, const RigidTransform& reference_from_new);

}  // namespace stemwise
