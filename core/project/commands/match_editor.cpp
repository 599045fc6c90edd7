#include "core/project/commands/match_editor.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/survey/tables.hpp"

namespace stemwise {
namespace {

template <class Map, class Key, class Value>
std::optional<Value> replace(Map& map, const Key& key, std::optional<Value> value) {
  std::optional<Value> old;
  if (const auto found = map.find(key); found != map.end()) old = found->second;
  if (value) {
    map.insert_or_assign(key, std::move(*value));
  } else {
    map.erase(key);
  }
  return old;
}

void point_stems_to(ProjectState& state, const TreeRecord& record) {
  for (const StemRef& stem : record.stems)
    state.tree_of_stem.at(stem.inventory).at(static_cast<std::size_t>(stem.index)) = record.id;
}

}  // namespace

std::string stem_label(const ProjectState& state, StemRef stem) {
  const Inventory* inventory = state.find(stem.inventory);
  const Stem* found = state.find(stem);
  return (inventory ? inventory->name : "?") + ":" + (found ? found->source_id : "?");
}

void MatchEditor::set_match(const StemPair& pair, std::optional<Match> match) {
  before_.matches.emplace_back(pair, replace(state_.matches, pair, std::move(match)));
}

void MatchEditor::set_tree(TreeId id, std::optional<TreeRecord> record) {
  if (record) point_stems_to(state_, *record);
  before_.trees.emplace_back(id, replace(state_.trees, id, std::move(record)));
}

Match MatchEditor::measured(StemRef a, StemRef b) const {
  Match match;
  std::tie(match.a, match.b) = ordered(a, b);
  match.distance_m = (state_.stem_in_reference_m(a) - state_.stem_in_reference_m(b)).head<2>().norm();
  match.confidence = 1.0;  // made by a person, or following from what a person decided
  return match;
}

void MatchEditor::set_match_state(StemRef a, StemRef b, MatchState match_state) {
  const auto found = state_.matches.find(ordered(a, b));
  Match match = found != state_.matches.end() ? found->second : measured(a, b);
  match.state = match_state;
  set_match(ordered(a, b), match);
}

void MatchEditor::note_edit(TreeId id, const EditStamp& stamp) {
  TreeRecord record = state_.trees.at(id);
  record.edited_by = stamp.author;
  set_tree(id, std::move(record));
}

void MatchEditor::keep_joined(TreeId id) {
  const std::vector<StemRef> stems = state_.trees.at(id).stems;
  for (std::size_t i = 1; i < stems.size(); ++i) {
    const auto joined = [&](const StemRef& earlier) {
      const auto match = state_.matches.find(ordered(earlier, stems[i]));
      return match != state_.matches.end() && match->second.joins();
    };
    if (!std::any_of(stems.begin(), stems.begin() + static_cast<std::ptrdiff_t>(i), joined))
      set_match(ordered(stems[i - 1], stems[i]), measured(stems[i - 1], stems[i]));
  }
}

TreeId MatchEditor::split(TreeId from, const std::vector<StemRef>& stems, const std::vector<StemPair>& must_reject) {
  TreeRecord stay = state_.trees.at(from);
  TreeRecord leave;
  for (const StemRef& stem : stems) std::erase(stay.stems, stem);
  if (stay.stems.empty() || stems.empty()) throw std::logic_error("a tree cannot be split into nothing and itself");
  leave.id = TreeId{state_.next_tree++};
  leave.stems = stems;
  std::sort(leave.stems.begin(), leave.stems.end());
  for (const StemRef& a : stay.stems)
    for (const StemRef& b : leave.stems)
      if (state_.matches.contains(ordered(a, b))) set_match_state(a, b, MatchState::rejected);
  for (const auto& [a, b] : must_reject) set_match_state(a, b, MatchState::rejected);
  set_tree(from, stay);
  set_tree(leave.id, leave);
  keep_joined(from);
  keep_joined(leave.id);
  return leave.id;
}

void MatchEditor::merge(TreeId into, TreeId from) {
  TreeRecord kept = state_.trees.at(into);
  const TreeRecord gone = state_.trees.at(from);
  kept.stems.insert(kept.stems.end(), gone.stems.begin(), gone.stems.end());
  std::sort(kept.stems.begin(), kept.stems.end());
  if (!gone.note.empty()) kept.note += (kept.note.empty() ? "" : "; ") + gone.note;
  if (!kept.fate_by_hand) kept.fate_by_hand = gone.fate_by_hand;
  for (const StemRef& a : state_.trees.at(into).stems)  // what kept them apart is overruled now
    for (const StemRef& b : gone.stems) {
      const auto match = state_.matches.find(ordered(a, b));
      if (match != state_.matches.end() && !match->second.joins()) set_match(ordered(a, b), std::nullopt);
    }
  set_tree(from, std::nullopt);
  set_tree(into, std::move(kept));
}

void MatchEditor::receive(TreeId id, StemRef gone, StemRef come) {
  TreeRecord record = state_.trees.at(id);
  std::erase(record.stems, gone);
  for (const StemRef& stem : record.stems) {
    set_match_state(stem, gone, MatchState::rejected);
    const auto match = state_.matches.find(ordered(stem, come));  // what kept them apart is overruled now
    if (match != state_.matches.end() && !match->second.joins()) set_match(ordered(stem, come), std::nullopt);
  }
  for (const StemRef& stem : record.stems) set_match_state(stem, come, MatchState::linked);
  record.stems.push_back(come);
  std::sort(record.stems.begin(), record.stems.end());
  set_tree(id, std::move(record));
}

void MatchEditor::exchange(StemRef a, StemRef b) {
  const TreeId tree_a = state_.tree_of(a), tree_b = state_.tree_of(b);
  receive(tree_a, a, b);
  receive(tree_b, b, a);
  keep_joined(tree_a);
  keep_joined(tree_b);
}

void MatchEditor::log(const EditStamp& stamp, std::string what, std::string before, std::string after) {
  state_.edit_log.push_back({stamp.time_utc, stamp.author, std::move(what), std::move(before), std::move(after), stamp.note});
}

MatchEditor::Before MatchEditor::take_before() {
  before_.next_tree = next_tree_;
  before_.log_size = log_size_;
  return std::move(before_);
}

void MatchEditor::restore(ProjectState& state, const Before& before) {
  for (auto step = before.matches.rbegin(); step != before.matches.rend(); ++step) replace(state.matches, step->first, step->second);
  for (auto step = before.trees.rbegin(); step != before.trees.rend(); ++step) {
    replace(state.trees, step->first, step->second);
    if (step->second) point_stems_to(state, *step->second);
  }
  state.next_tree = before.next_tree;
  state.edit_log.resize(before.log_size);
}

}  // namespace stemwise
