#include <algorithm>

#include "app/rough_poses.hpp"
#include "app/window/requests.hpp"
#include "core/project/commands.hpp"
#include "ui/frame.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

constexpr double far_from_m = 1.0;
constexpr double contradicted_from_m = 2.5;  ///< pose_by_hand brings pairs together to this

/// The stem of the same tree in the reference: that is what a pair means to the alignment.
StemRef in_reference(const ProjectState& state, StemRef stem) {
  const auto tree = state.trees.find(state.tree_of(stem));
  if (tree == state.trees.end()) return stem;
  for (const StemRef& other : tree->second.stems) {
    if (other.inventory == state.reference) return other;
  }
  return stem;
}

/// What became of the pairs that a person named, once their surveys have a pose.
struct NamedPairs {
  std::vector<std::pair<StemRef, StemRef>> joined;  ///< decisions from now on, so that later runs keep them
  Issues far_apart;
};

NamedPairs named_pairs(const ProjectState& state, const SurveyAlignment& result, const std::vector<std::pair<StemRef, StemRef>>& pairs) {
  NamedPairs named;
  for (const auto& [known, other] : pairs) {
    const Stem *a = state.find(known), *b = state.find(other);
    const auto of_it = [id = other.inventory](const InventoryAlignment& one) { return one.inventory == id; };
    const auto pose = std::find_if(result.inventories.begin(), result.inventories.end(), of_it);
    if (a == nullptr || b == nullptr || pose == result.inventories.end() || pose->status != AlignmentStatus::aligned) continue;
    const Eigen::Vector3d there = pose->reference_from_inventory * Eigen::Vector3d(b->x_m, b->y_m, b->z_m.value_or(0.0));
    const double apart_m = (there.head<2>() - Eigen::Vector2d(a->x_m, a->y_m)).norm();
    const std::string words = ui::stem_label(state, known) + " and " + ui::stem_label(state, other) + " lie " + ui::distance_text(apart_m) + " apart";
    const bool contradicted = apart_m > contradicted_from_m;
    if (apart_m > far_from_m) {  // whatever the noise: a wrong pair makes it large
      named.far_apart.push_back({Severity::warning, "", 0, "", words + (contradicted ? ": not linked, the other pairs say otherwise" : ", and are linked since you named them"),
                                 "If they are not the same tree, undo the alignment, take the pair out and name another one."});
    }
    if (!contradicted) named.joined.emplace_back(known, other);
  }
  return named;
}

}  // namespace

void pair_stem(WindowModel& m, StemRef stem) {
  const ProjectState& state = m.document.state();
  if (state.find(stem) == nullptr) return;
  if (m.view.link_from.index < 0) {
    m.view.link_from = stem;
    return;
  }
  const StemRef first = std::exchange(m.view.link_from, StemRef{});
  const bool forth = state.is_placed(first.inventory) && !state.is_placed(stem.inventory), back = state.is_placed(stem.inventory) && !state.is_placed(first.inventory);
  const StemRef known = in_reference(state, forth ? first : stem), other = forth ? stem : first;
  if (!(forth || back) || known.inventory != state.reference) {
    m.notices.add(Severity::warning, "A pair is one stem of " + ui::survey_label(state, state.reference) + " and one of the survey that is not aligned");
    return;
  }
  std::erase_if(m.view.pairs, [&](const auto& pair) { return pair.second == other || (pair.first == known && pair.second.inventory == other.inventory); });
  m.view.pairs.emplace_back(known, other);
}

void align_by_pairs(WindowModel& m) {
  m.view.tool = ui::Tool::select;
  m.view.link_from = {};
  run_alignment(m);
}

void accept_pose_of(WindowModel& m, InventoryId inventory) {
  m.execute(accept_proposed_pose(m.document.state(), inventory, stamp_now()));
  run_alignment(m);
}

void apply_with_named_pairs(WindowModel& m, AlignOutcome outcome) {
  const NamedPairs named = named_pairs(m.document.state(), outcome.alignment, m.view.pairs);
  std::vector<CommandPtr> commands;
  commands.push_back(apply_outcome(std::move(outcome)));
  std::string label = commands.front()->label();
  for (const auto& [known, other] : named.joined) commands.push_back(link_stems(known, other, stamp_now("named to align the survey")));
  m.execute(named.joined.empty() ? std::move(commands.front()) : group(std::move(label), std::move(commands)));
  m.notices.add_issues("Pairs that you named lie far apart", named.far_apart);
  forget_used_pairs(m);
}

void forget_used_pairs(WindowModel& m) {
  const ProjectState& state = m.document.state();
  std::erase_if(m.view.pairs, [&](const auto& pair) { return state.find(pair.first) == nullptr || state.find(pair.second) == nullptr || state.is_placed(pair.second.inventory); });
}

}  // namespace stemwise
