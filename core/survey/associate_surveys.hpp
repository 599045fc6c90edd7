#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/base/ids.hpp"
#include "core/forest/inventory.hpp"
#include "core/jobs/progress.hpp"
#include "core/survey/align_surveys.hpp"
#include "core/survey/list_pair.hpp"

namespace stemwise {

/// An aligned survey as association sees it: all stems, one node each, in the reference's plane.
struct PlacedSurvey {
  const Inventory* inventory = nullptr;
  IndexedList list;                    ///< relative to an origin common to all
  std::vector<std::size_t> stem_of;    ///< index in the inventory, per node
  double noise_m = 0.3;                ///< a first idea of the difference to the others, one axis
};

/// One stem of one survey as part of a tree.
struct StemSighting {
  std::size_t survey = 0;  ///< place in the span of surveys
  std::size_t node = 0;
  double confidence = 1.0;
  bool by_hand = false;
  std::optional<StemRef> second_choice;
  double second_distance_m = 0.0;
};

/// Sightings of one tree, by survey; at most one of each.
using SightedTree = std::vector<StemSighting>;

/// Which stems of n surveys are one tree. The surveys come in order of time; each is matched to the trees of those before it
/// (their mean place, the DBH to expect by then, and how often they were missed since), then once more to those of all
/// others. Every step is a globally optimal one-to-one assignment, so that no tree has two stems of one survey.
std::vector<SightedTree> associate_surveys(std::span<const PlacedSurvey> surveys, const AlignHints& hints, double noise_floor_m, const Progress& progress);

/// The matches of all trees: one per pair of consecutive sightings.
std::vector<Match> consecutive_matches(std::span<const PlacedSurvey> surveys, const std::vector<SightedTree>& trees);

}  // namespace stemwise
