#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/survey/grow_pose.hpp"

namespace stemwise {

/// Stems of a and b that a person says are the same tree.
using NamedPair = std::pair<std::size_t, std::size_t>;

/// The pose that named pairs ask for.
struct HandPose {
  PoseFit fit;                          ///< means something where two pairs or more agree
  std::vector<NamedPair> agreeing;
  std::vector<NamedPair> contradicted;  ///< what the agreeing ones would lay metres apart
};

/// The largest set of named pairs that one rigid pose brings together (to 2.5 m), refined on the stems around them unless that would
/// take them apart again. Nothing when fewer than two of the pairs have a place, or all lie at one spot (no heading).
std::optional<HandPose> pose_by_hand(const IndexedList& a, const IndexedList& b, const std::vector<NamedPair>& same_tree, double noise_floor_m);

/// Those of the pairs that a pose lays farther apart than that.
std::vector<NamedPair> pairs_apart(const IndexedList& a, const IndexedList& b, const PlanarPose& b_from_a, const std::vector<NamedPair>& same_tree);

}  // namespace stemwise
