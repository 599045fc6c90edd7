#include "app/align_job.hpp"

#include "core/survey/coverage.hpp"

namespace stemwise {
namespace {

void add_decisions(const ProjectState& state, AlignHints& hints) {
  for (const auto& [pair, match] : state.matches) {
    if (match.state == MatchState::automatic) continue;
    (match.joins() ? hints.same_tree : hints.not_same).push_back({pair.first, pair.second});
  }
}

}  // namespace

AlignOutcome align_project(const ProjectState& state, const AlignSettings& settings, AlignHints hints, const Progress& progress) {
  add_decisions(state, hints);
  std::vector<const Inventory*> inventories;
  for (const auto& inventory : state.inventories) inventories.push_back(inventory.get());
  AlignOutcome outcome;
  outcome.alignment = align_surveys(inventories, state.reference, settings, hints, progress);
  for (const Inventory* inventory : inventories) {
    progress.check();
    outcome.coverages.emplace_back(inventory->id, estimate_coverage(*inventory));
  }
  return outcome;
}

}  // namespace stemwise
