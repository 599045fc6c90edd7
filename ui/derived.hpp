#pragma once
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/survey/fusion_review.hpp"
#include "core/survey/tables.hpp"

namespace stemwise::ui {

/// Of one survey's stems those where another survey looked too, and those of them that it found there.
struct InOverlap {
  int stems = 0;
  int matched = 0;
};

/// The tables of one revision with look-ups by tree, made by a worker: no panel goes through all trees in a frame.
struct Derived {
  std::uint64_t revision = 0;
  Tables tables;
  std::unordered_map<TreeId, std::vector<std::size_t>> observations;  ///< into tables.observations, in survey order
  std::unordered_map<TreeId, std::vector<std::size_t>> matches;       ///< into tables.matches
  std::unordered_map<TreeId, std::size_t> trees;
  std::unordered_map<TreeId, std::size_t> queue;                      ///< the first (most doubtful) entry of a tree
  std::unordered_map<InventoryId, InOverlap> in_overlap;              ///< of each placed survey
  std::array<int, fate_count> last_step_fates{};                      ///< of the trees seen in one of the last two surveys
  int dead_before = 0;                                                ///< recorded as dead in the first of the two already, or before
  int seen_before_only = 0;                                           ///< trees last seen before these two
  std::vector<FusionConflict> conflicts;                              ///< between surveys, on merged trees
  int decided = 0;                                                    ///< of the queue

  const TreeRow* tree(TreeId id) const;
  std::vector<const ObservationRow*> sightings(TreeId id) const;
  std::vector<const MatchRow*> matches_of(TreeId id) const;
  const QueueRow* doubt(TreeId id) const;
};

Derived derive(const ProjectState& state, std::uint64_t revision);

}  // namespace stemwise::ui
