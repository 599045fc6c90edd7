#include "ui/derived.hpp"

#include <algorithm>

namespace stemwise::ui {

const TreeRow* Derived::tree(TreeId id) const {
  const auto it = trees.find(id);
  return it == trees.end() ? nullptr : &tables.trees[it->second];
}

std::vector<const ObservationRow*> Derived::sightings(TreeId id) const {
  std::vector<const ObservationRow*> rows;
  if (const auto it = observations.find(id); it != observations.end()) {
    for (const std::size_t i : it->second) rows.push_back(&tables.observations[i]);
  }
  return rows;
}

std::vector<const MatchRow*> Derived::matches_of(TreeId id) const {
  std::vector<const MatchRow*> rows;
  if (const auto it = matches.find(id); it != matches.end()) {
    for (const std::size_t i : it->second) rows.push_back(&tables.matches[i]);
  }
  return rows;
}

const QueueRow* Derived::doubt(TreeId id) const {
  const auto it = queue.find(id);
  return it == queue.end() ? nullptr : &tables.queue[it->second];
}

namespace {

void count_overlap(Derived& d) {
  const Tables& t = d.tables;
  const auto looked = [&](const CoverageRow& row, const ObservationRow& stem) {
    return row.inventory != stem.stem.inventory && contains(row.in_reference, stem.position_m.head<2>());
  };
  for (const ObservationRow& stem : t.observations) {
    const bool matched = d.observations[stem.tree].size() > 1;
    if (!matched && std::none_of(t.coverages.begin(), t.coverages.end(), [&](const CoverageRow& row) { return looked(row, stem); })) continue;
    InOverlap& count = d.in_overlap[stem.stem.inventory];
    ++count.stems;
    count.matched += matched ? 1 : 0;
  }
}

bool was_dead_before(const Derived& d, const ProjectState& state, TreeId tree, InventoryId last) {
  const std::vector<std::size_t>& seen = d.observations.at(tree);
  return std::any_of(seen.begin(), seen.end(), [&](std::size_t i) {
    const StemRef stem = d.tables.observations[i].stem;
    return stem.inventory != last && !is_living(state.find(stem)->status);
  });
}

void count_fates(Derived& d, const ProjectState& state) {
  const std::vector<InventoryId>& surveys = d.tables.inventories;
  if (surveys.size() < 2) return;
  const InventoryId from = surveys[surveys.size() - 2], to = surveys.back();
  for (const TreeRow& tree : d.tables.trees) {
    if (was_dead_before(d, state, tree.tree, to)) {
      ++d.dead_before;
    } else if (tree.last_seen == from || tree.last_seen == to) {
      ++d.last_step_fates[static_cast<std::size_t>(tree.fate)];
    } else {
      ++d.seen_before_only;
    }
  }
}

}  // namespace

Derived derive(const ProjectState& state, std::uint64_t revision) {
  Derived d;
  d.revision = revision;
  d.tables = derive_tables(state);
  const Tables& t = d.tables;
  for (std::size_t i = 0; i < t.observations.size(); ++i) d.observations[t.observations[i].tree].push_back(i);
  for (std::size_t i = 0; i < t.matches.size(); ++i) d.matches[t.matches[i].tree].push_back(i);
  for (std::size_t i = 0; i < t.trees.size(); ++i) d.trees[t.trees[i].tree] = i;
  for (std::size_t i = 0; i < t.queue.size(); ++i) {
    d.queue.try_emplace(t.queue[i].tree, i);
    d.decided += t.queue[i].decided ? 1 : 0;
  }
  const auto place = [&](InventoryId id) { return std::find(t.inventories.begin(), t.inventories.end(), id) - t.inventories.begin(); };
  for (auto& [tree, rows] : d.observations) {
    std::stable_sort(rows.begin(), rows.end(),
                     [&](std::size_t a, std::size_t b) { return place(t.observations[a].stem.inventory) < place(t.observations[b].stem.inventory); });
  }
  count_overlap(d);
  count_fates(d, state);
  d.conflicts = fusion_conflicts(state, t);
  return d;
}

}  // namespace stemwise::ui
