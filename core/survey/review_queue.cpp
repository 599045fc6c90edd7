#include "core/survey/review_queue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

namespace stemwise {
namespace {

constexpr double least_doubt = 0.15;

/// How the reason of each kind begins, as it is written below, and what the kind is called.
struct KindWords {
  const char* begins;
  const char* label;
};
constexpr std::array<KindWords, doubt_kind_count> kind_words{{{"second candidate", "Second candidate"},
                                                              {"shrank", "Shrank"},
                                                              {"grew", "Grew too fast"},
                                                              {"residual", "Large residual"},
                                                              {"matched across a species change", "Species change"},
                                                              {"confidence", "Low confidence"},
                                                              {"dead, removed", "Missing inside coverage"},
                                                              {"at the edge", "Edge of coverage"},
                                                              {"too big to be ingrowth", "Missed earlier"},
                                                              {"", "Other"}}};

std::string words(const char* format, double a, double b = 0.0) {
  std::array<char, 96> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, a, b);
  return buffer.data();
}

struct Doubt {
  double weight = 0.0;
  std::string why;
  void raise(double other, std::string text) {
    if (other <= weight) return;
    weight = other;
    why = std::move(text);
  }
};

double dbh_error_m(const Tables& tables, InventoryId from, InventoryId to) {
  for (const GrowthRow& row : tables.growth)
    if (row.from == from && row.to == to) return row.dbh_error_m;
  return 0.01;
}

/// Of the match as it was found, whatever a person has decided since.
Doubt doubt_of_match(const ProjectState& state, const Tables& tables, const MatchRow& match) {
  Doubt doubt;
  if (match.state == MatchState::rejected) return doubt;
  const auto found = state.matches.find(ordered(match.a, match.b));
  const double confidence = found == state.matches.end() ? match.confidence : found->second.confidence;
  const double error_m = std::max(0.005, dbh_error_m(tables, match.a.inventory, match.b.inventory));
  const auto noise = state.alignments.find(match.b.inventory);
  const double noise_m = std::max(0.1, noise == state.alignments.end() ? 0.1 : noise->second.position_noise_m);
  if (match.second_distance_m && *match.second_distance_m < match.distance_m + 3.0 * noise_m)
    doubt.raise(std::max(1.0 - confidence, 0.2), words("second candidate %.2f m away", *match.second_distance_m));
  if (match.change == ChangeClass::shrank)
    doubt.raise(std::min(0.9, 0.15 * std::abs(*match.change_m) / error_m),
                words("shrank %.1f cm, error %.1f cm", -100.0 * *match.change_m, 100.0 * error_m));
  if (match.distance_m > 3.0 * noise_m) doubt.raise(1.0 - confidence, words("residual %.2f m", match.distance_m));
  if (!match.years && match.change_m && *match.change_m > 0.1) doubt.raise(std::min(0.9, 3.0 * *match.change_m), words("grew %.1f cm", 100.0 * *match.change_m));
  if (match.growth_m_per_year && *match.growth_m_per_year > 0.03)
    doubt.raise(std::min(0.9, 10.0 * *match.growth_m_per_year), words("grew %.0f mm per year", 1000.0 * *match.growth_m_per_year));
  const Stem* a = state.find(match.a);
  const Stem* b = state.find(match.b);
  if (!a->species.empty() && !b->species.empty() && a->species != b->species)
    doubt.raise(0.45, "matched across a species change: " + a->species + " to " + b->species);
  doubt.raise(1.0 - confidence, words("confidence %.2f", confidence));
  return doubt;
}

Doubt doubt_of_tree(const TreeRow& tree) {
  Doubt doubt;
  if (tree.fate == Fate::missing) doubt.raise(0.3, "dead, removed or overlooked?");
  if (tree.fate == Fate::unresolved && tree.times_seen > 0) doubt.raise(0.25, "at the edge of coverage, or without DBH");
  if (tree.fate == Fate::missed_earlier) doubt.raise(0.22, "too big to be ingrowth: missed earlier?");
  return doubt;
}

}  // namespace

const char* doubt_label(DoubtKind kind) { return kind_words[static_cast<std::size_t>(kind)].label; }

DoubtKind kind_of(const QueueRow& row) {
  std::size_t kind = 0;
  while (!row.why.starts_with(kind_words[kind].begins)) ++kind;  // the last one begins every reason
  return static_cast<DoubtKind>(kind);
}

std::vector<QueueRow> review_queue(const ProjectState& state, const Tables& tables) {
  std::vector<QueueRow> queue;
  std::set<TreeId> spoken_of;  // a swap makes and breaks many pairs: one answer per tree
  if (tables.inventories.size() < 2) return queue;
  for (std::size_t i = 0; i < tables.matches.size(); ++i) {
    const MatchRow& match = tables.matches[i];
    const Doubt doubt = doubt_of_match(state, tables, match);
    const bool decided = match.state != MatchState::automatic;
    const bool by_hand = match.state == MatchState::rejected || match.state == MatchState::linked;  // accepting what nobody doubted is no answer
    const bool doubted = doubt.weight >= least_doubt;
    if (doubted || (by_hand && spoken_of.insert(match.tree).second)) queue.push_back({match.tree, i, doubt.weight, doubt.why, decided});
  }
  for (const TreeRow& tree : tables.trees) {
    const Doubt doubt = doubt_of_tree(tree);
    const bool decided = state.trees.at(tree.tree).fate_by_hand.has_value();
    if (doubt.weight >= least_doubt || decided)
      queue.push_back({tree.tree, std::nullopt, doubt.weight, decided ? "marked by hand" : doubt.why, decided});
  }
  std::stable_sort(queue.begin(), queue.end(), [](const QueueRow& a, const QueueRow& b) {
    if (a.decided != b.decided) return !a.decided;
    return a.doubt > b.doubt;
  });
  std::set<TreeId> asked;  // a tree is asked about once: first what is most in doubt about it, the rest when that is decided
  std::erase_if(queue, [&](const QueueRow& row) { return !row.decided && !asked.insert(row.tree).second; });
  return queue;
}

}  // namespace stemwise
