#include <stdexcept>

#include "core/project/assign_trees.hpp"
#include "core/project/commands.hpp"
#include "core/project/commands/whole_state.hpp"

namespace stemwise {
namespace {

void replace_automatic_matches(ProjectState& state, const std::vector<Match>& found) {
  std::erase_if(state.matches, [](const auto& entry) { return entry.second.state == MatchState::automatic; });
  for (const Match& match : found) {
    const auto [place, is_new] = state.matches.try_emplace(ordered(match.a, match.b), match);
    if (is_new) {
      place->second.state = MatchState::automatic;
      continue;
    }
    Match updated = match;  // a decision by hand keeps its word and takes the new figures
    updated.state = place->second.state;
    place->second = updated;
  }
}

void take_alignment(ProjectState& state, const SurveyAlignment& result) {
  state.reference = result.reference;
  state.alignments.clear();
  for (const InventoryAlignment& alignment : result.inventories) state.alignments[alignment.inventory] = alignment;
  state.pairs = result.pairs;
  replace_automatic_matches(state, result.matches);
}

}  // namespace

CommandPtr apply_alignment(SurveyAlignment result, std::vector<std::pair<InventoryId, Coverage>> coverages) {
  return whole_state("Align inventories", [result = std::move(result), coverages = std::move(coverages)](ProjectState& state) {
    take_alignment(state, result);
    for (const auto& [id, coverage] : coverages) {
      const auto old = state.coverages.find(id);
      if (old == state.coverages.end() || old->second.source != CoverageSource::drawn) state.coverages[id] = coverage;
    }
    assign_trees(state);
  });
}

}  // namespace stemwise
