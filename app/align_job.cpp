#include "app/align_job.hpp"

#include "app/with_frames.hpp"
#include "core/survey/coverage.hpp"

namespace stemwise {
namespace {

void add_decisions(const ProjectState& state, AlignHints& hints) {
  for (const auto& [pair, match] : state.matches) {
    if (match.state == MatchState::automatic) continue;
    (match.joins() ? hints.same_tree : hints.not_same).push_back({pair.first, pair.second});
  }
}

AlignBase base_of(const ProjectState& state) {
  AlignBase base;
  for (const auto& [id, alignment] : state.alignments)
    if (state.is_placed(id)) base.poses.push_back(alignment);
  for (const auto& [id, tree] : state.trees) base.trees.push_back(tree.stems);
  return base;
}

/// What the base had, put back in front of what was found.
void keep_base(const ProjectState& state, SurveyAlignment& result) {
  std::vector<PairReport> pairs = state.pairs;
  pairs.insert(pairs.end(), result.pairs.begin(), result.pairs.end());
  result.pairs = std::move(pairs);
  for (const auto& [key, match] : state.matches)
    if (match.state == MatchState::automatic && state.is_placed(match.a.inventory) && state.is_placed(match.b.inventory)) result.matches.push_back(match);
}

}  // namespace

AlignOutcome align_project(const ProjectState& state, const AlignSettings& settings, AlignHints hints, const Progress& progress) {
  add_decisions(state, hints);
  std::vector<std::shared_ptr<const Inventory>> held;
  std::vector<const Inventory*> inventories;
  std::vector<std::string> notes;
  for (const auto& inventory : state.inventories) {
    progress.at(0.0, "Reading " + inventory->name);
    held.push_back(with_frames(inventory, settings.threads, notes));
    inventories.push_back(held.back().get());
  }
  AlignOutcome outcome;
  outcome.alignment = align_surveys(inventories, state.reference, settings, hints, progress);
  outcome.alignment.notes.insert(outcome.alignment.notes.begin(), notes.begin(), notes.end());
  for (const Inventory* inventory : inventories) {
    progress.check();
    outcome.coverages.emplace_back(inventory->id, estimate_coverage(*inventory));
  }
  return outcome;
}

AlignOutcome align_added(const ProjectState& state, const AlignSettings& settings, AlignHints hints, const Progress& progress) {
  hints.base = base_of(state);
  AlignOutcome outcome = align_project(state, settings, std::move(hints), progress);
  keep_base(state, outcome.alignment);
  std::erase_if(outcome.coverages, [&](const auto& entry) { return state.coverages.contains(entry.first); });
  return outcome;
}

}  // namespace stemwise
