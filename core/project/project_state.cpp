#include "core/project/project_state.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/forest/time_order.hpp"

namespace stemwise {
namespace {

constexpr std::array<const char*, 4> policy_words{"min-dbh", "newest", "best", "mean"};
constexpr std::array<const char*, 3> coverage_words{"stems", "frames", "drawn"};

bool equal_inventories(const std::vector<std::shared_ptr<const Inventory>>& a,
                       const std::vector<std::shared_ptr<const Inventory>>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& p, const auto& q) { return p == q || (p && q && *p == *q); });
}

}  // namespace

StemPair ordered(StemRef a, StemRef b) { return a < b ? StemPair{a, b} : StemPair{b, a}; }

const char* to_string(FusionPolicy policy) { return policy_words[static_cast<std::size_t>(policy)]; }

std::optional<FusionPolicy> fusion_policy_from(const std::string& word) {
  const auto found = std::find(policy_words.begin(), policy_words.end(), word);
  if (found == policy_words.end()) return std::nullopt;
  return static_cast<FusionPolicy>(found - policy_words.begin());
}

const char* to_string(CoverageSource source) { return coverage_words[static_cast<std::size_t>(source)]; }

bool ProjectState::operator==(const ProjectState& o) const {
  return title == o.title && equal_inventories(inventories, o.inventories) && reference == o.reference &&
         alignments == o.alignments && coverages == o.coverages && pairs == o.pairs && matches == o.matches && trees == o.trees &&
         tree_of_stem == o.tree_of_stem && next_tree == o.next_tree && next_inventory == o.next_inventory &&
         georeference == o.georeference && fusion == o.fusion && dbh_error_m == o.dbh_error_m && settings == o.settings &&
         edit_log == o.edit_log;
}

const Inventory* ProjectState::find(InventoryId id) const {
  const auto found = std::find_if(inventories.begin(), inventories.end(), [&](const auto& i) { return i->id == id; });
  return found == inventories.end() ? nullptr : found->get();
}

const Inventory* ProjectState::find(const std::string& name) const {
  const auto found = std::find_if(inventories.begin(), inventories.end(), [&](const auto& i) { return i->name == name; });
  return found == inventories.end() ? nullptr : found->get();
}

const Stem* ProjectState::find(StemRef stem) const {
  const Inventory* inventory = find(stem.inventory);
  if (inventory == nullptr || stem.index < 0 || stem.index >= static_cast<std::int64_t>(inventory->stems.size())) return nullptr;
  return &inventory->stems[static_cast<std::size_t>(stem.index)];
}

bool ProjectState::is_placed(InventoryId id) const {
  if (id == reference) return static_cast<bool>(id);
  const auto found = alignments.find(id);
  return found != alignments.end() && found->second.status == AlignmentStatus::aligned;
}

RigidTransform ProjectState::reference_from_inventory(InventoryId id) const {
  if (id == reference) return {};
  if (!is_placed(id)) throw std::logic_error("an inventory without a pose was asked for its place");
  return alignments.at(id).reference_from_inventory;
}

Eigen::Vector3d ProjectState::stem_in_reference_m(StemRef stem) const {
  const Stem* found = find(stem);
  if (found == nullptr) throw std::logic_error("a stem that is not there was asked for its place");
  return reference_from_inventory(stem.inventory) * Eigen::Vector3d(found->x_m, found->y_m, found->z_m.value_or(0.0));
}

TreeId ProjectState::tree_of(StemRef stem) const {
  const auto found = tree_of_stem.find(stem.inventory);
  if (found == tree_of_stem.end() || stem.index < 0 || stem.index >= static_cast<std::int64_t>(found->second.size())) return {};
  return found->second[static_cast<std::size_t>(stem.index)];
}

std::vector<InventoryId> ProjectState::by_date() const {
  std::vector<std::optional<Date>> dates;
  for (const auto& inventory : inventories) dates.push_back(inventory->date);
  std::vector<InventoryId> ids;
  for (const std::size_t i : time_order(dates)) ids.push_back(inventories[i]->id);
  return ids;
}

}  // namespace stemwise
