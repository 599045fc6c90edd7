#include "core/project/assign_trees.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

namespace stemwise {
namespace {

/// Disjoint groups of stems that know their members.
class Groups {
 public:
  std::size_t add(StemRef stem) {
    const auto [place, is_new] = index_.try_emplace(stem, members_.size());
    if (is_new) {
      members_.push_back({stem});
      parent_.push_back(place->second);
    }
    return place->second;
  }
  bool has(StemRef stem) const { return index_.contains(stem); }
  std::size_t root(StemRef stem) {
    std::size_t r = index_.at(stem);
    while (parent_[r] != r) r = parent_[r] = parent_[parent_[r]];
    return r;
  }
  void join(std::size_t a, std::size_t b) {
    if (members_[a].size() < members_[b].size()) std::swap(a, b);
    members_[a].insert(members_[a].end(), members_[b].begin(), members_[b].end());
    members_[b].clear();
    parent_[b] = a;
  }
  const std::vector<StemRef>& members(std::size_t root) const { return members_[root]; }
  std::vector<std::vector<StemRef>> all() const {
    std::vector<std::vector<StemRef>> out;
    for (std::vector<StemRef> group : members_)
      if (!group.empty()) {
        std::sort(group.begin(), group.end());
        out.push_back(std::move(group));
      }
    std::sort(out.begin(), out.end());
    return out;
  }

 private:
  std::unordered_map<StemRef, std::size_t> index_;
  std::vector<std::size_t> parent_;
  std::vector<std::vector<StemRef>> members_;
};

bool compatible(const std::vector<StemRef>& a, const std::vector<StemRef>& b, const ProjectState& state) {
  for (const StemRef& p : a)
    for (const StemRef& q : b) {
      if (p.inventory == q.inventory) return false;
      const auto match = state.matches.find(ordered(p, q));
      if (match != state.matches.end() && !match->second.joins()) return false;
    }
  return true;
}

Groups placed_stems(const ProjectState& state) {
  Groups groups;
  for (const auto& inventory : state.inventories)
    if (state.is_placed(inventory->id))
      for (std::size_t i = 0; i < inventory->stems.size(); ++i) groups.add({inventory->id, static_cast<std::int64_t>(i)});
  return groups;
}

/// Joins by hand first, then the automatic ones, surest first; those that do not fit are returned.
std::vector<StemPair> join_matches(Groups& groups, const ProjectState& state) {
  std::vector<const Match*> order;
  for (const auto& [key, match] : state.matches)
    if (match.joins() && groups.has(match.a) && groups.has(match.b)) order.push_back(&match);
  std::stable_sort(order.begin(), order.end(), [](const Match* a, const Match* b) {
    const bool a_hand = a->state != MatchState::automatic, b_hand = b->state != MatchState::automatic;
    if (a_hand != b_hand) return a_hand;
    return a->confidence > b->confidence;
  });
  std::vector<StemPair> dropped;
  for (const Match* match : order) {
    const std::size_t a = groups.root(match->a), b = groups.root(match->b);
    if (a == b) continue;
    if (compatible(groups.members(a), groups.members(b), state)) {
      groups.join(a, b);
    } else if (match->state == MatchState::automatic) {
      dropped.push_back(ordered(match->a, match->b));
    }
  }
  return dropped;
}

struct Claim {
  TreeId id;
  std::size_t stems = 0;
  std::size_t group = 0;
};

/// Every group's share in every earlier tree, strongest first.
std::vector<Claim> claims_on_ids(const std::vector<std::vector<StemRef>>& groups, const ProjectState& state) {
  std::vector<Claim> claims;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::map<TreeId, std::size_t> share;
    for (const StemRef& stem : groups[g])
      if (const TreeId id = state.tree_of(stem)) ++share[id];
    for (const auto& [id, stems] : share) claims.push_back({id, stems, g});
  }
  std::stable_sort(claims.begin(), claims.end(), [](const Claim& a, const Claim& b) {
    if (a.stems != b.stems) return a.stems > b.stems;
    return a.id != b.id ? a.id < b.id : a.group < b.group;
  });
  return claims;
}

std::vector<TreeId> give_ids(const std::vector<std::vector<StemRef>>& groups, const ProjectState& state) {
  std::vector<TreeId> ids(groups.size());
  std::set<TreeId> taken;
  for (const Claim& claim : claims_on_ids(groups, state))
    if (!ids[claim.group] && taken.insert(claim.id).second) ids[claim.group] = claim.id;
  return ids;
}

}  // namespace

void assign_trees(ProjectState& state) {
  Groups joined = placed_stems(state);
  for (const StemPair& pair : join_matches(joined, state)) state.matches.erase(pair);
  const std::vector<std::vector<StemRef>> groups = joined.all();
  const std::vector<TreeId> ids = give_ids(groups, state);
  std::map<TreeId, TreeRecord> trees;
  std::map<InventoryId, std::vector<TreeId>> tree_of_stem;
  for (const auto& inventory : state.inventories)
    if (state.is_placed(inventory->id)) tree_of_stem[inventory->id].resize(inventory->stems.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const TreeId id = ids[g] ? ids[g] : TreeId{state.next_tree++};
    TreeRecord record;
    if (const auto old = state.trees.find(id); old != state.trees.end()) record = old->second;
    record.id = id;
    record.stems = groups[g];
    for (const StemRef& stem : groups[g]) tree_of_stem[stem.inventory][static_cast<std::size_t>(stem.index)] = id;
    trees.emplace_hint(trees.end(), id, std::move(record));
  }
  state.trees = std::move(trees);
  state.tree_of_stem = std::move(tree_of_stem);
}

}  // namespace stemwise
