#include "ui/actions/availability.hpp"

#include <algorithm>

#include "core/project/commands.hpp"
#include "core/project/regroup_commands.hpp"
#include "ui/frame.hpp"

namespace stemwise::ui {
namespace {

using enum ActionId;

/// Sets a reason once; the first one counts.
class Reasons {
 public:
  explicit Reasons(Availabilities& out) : out_(out) {}
  void unless(bool possible, std::initializer_list<ActionId> ids, const std::string& why) {
    if (possible) return;
    for (const ActionId id : ids) {
      std::string& reason = out_[static_cast<std::size_t>(id)].why_not;
      if (reason.empty()) reason = why;
    }
  }

 private:
  Availabilities& out_;
};

void project_reasons(Reasons& r, const Project& project, const ViewState& view, const WindowStatus& status) {
  const ProjectState& state = project.state();
  const bool busy = status.running() != nullptr;
  r.unless(!busy, {file_new, file_open, file_demo, align_run}, "Wait until the running job is done, or cancel it");
  r.unless(busy, {align_cancel}, "No job is running");
  r.unless(view.zoom_percent < status.most_zoom_percent, {view_zoom_in}, status.most_zoom_percent < 200.0 ? "The window is too small for larger text" : "The text cannot be larger");
  r.unless(view.zoom_percent > 80.0, {view_zoom_out}, "The text cannot be smaller");
  r.unless(!state.inventories.empty(), {file_save, file_save_as, file_underlay, view_fit, view_blink}, "Add inventories first");
  r.unless(!view.underlays.empty(), {view_underlays}, "There is no underlay: add one in the menu File");
  r.unless(project.can_undo(), {edit_undo}, "Nothing to undo");
  r.unless(project.can_redo(), {edit_redo}, "Nothing to redo");
  r.unless(project.can_undo() || project.can_redo(), {edit_history}, "Nothing has been changed yet");
  r.unless(state.inventories.size() >= 2, {align_run}, "Alignment needs two inventories or more");
  const Inventory* selected = state.find(view.selected_inventory);
  r.unless(selected != nullptr, {edit_make_reference, edit_remove_inventory, align_accept_probable}, "Select an inventory in the left panel first");
  r.unless(view.selected_inventory != state.reference, {edit_make_reference}, "It is the reference already");
  const bool others_lie = std::any_of(state.alignments.begin(), state.alignments.end(), [&](const auto& entry) { return entry.first != state.reference && state.is_placed(entry.first); });
  r.unless(selected == nullptr || !others_lie || state.is_placed(view.selected_inventory), {edit_make_reference}, "Align it first: as the reference it would take their places from the surveys that are aligned");
  r.unless(selected != nullptr && state.is_placed(view.selected_inventory), {edit_coverage}, "Select an inventory in the left panel that has a place: the reference, or an aligned one");
  const InventoryId compared = survey_to_compare(state, view);
  r.unless(compared && state.is_placed(compared), {view_before_after}, "No survey was aligned to the reference yet");
  const auto other = state.alignments.find(compared);
  r.unless(other != state.alignments.end() && (other->second.second_best_pose || other->second.status == AlignmentStatus::probable), {view_ghost}, "No second-best pose is known of the selected survey");
  const auto it = state.alignments.find(view.selected_inventory);
  r.unless(it != state.alignments.end() && it->second.status == AlignmentStatus::probable, {align_accept_probable},
           "The selected inventory has no pose that waits for a decision");
}

constexpr std::initializer_list<ActionId> fate_actions{review_dead, review_removed, review_missed_earlier, review_ingrowth, review_clear_fate};

/// Decisions on several trees at once.
void group_reasons(Reasons& r, const Derived& derived, const ViewState& view) {
  const auto any = [&](const auto& holds) { return std::any_of(view.group.begin(), view.group.end(), holds); };
  const auto open_match = [&](TreeId tree) {
    const std::vector<const MatchRow*> rows = derived.matches_of(tree);
    return std::any_of(rows.begin(), rows.end(), [](const MatchRow* m) { return m->state == MatchState::automatic; });
  };
  const auto open_doubt = [&](TreeId tree, bool of_match) {
    const QueueRow* doubt = derived.doubt(tree);
    return doubt != nullptr && !doubt->decided && doubt->match.has_value() == of_match;
  };
  r.unless(any([&](TreeId t) { return open_match(t) || open_doubt(t, false); }), {review_accept}, "All matches of the selected trees are decided");
  r.unless(any([&](TreeId t) { return open_doubt(t, true); }), {review_reject}, "No match of the selected trees is in doubt");
  r.unless(false, {view_focus, review_link, review_unlink, review_swap, review_split, review_merge}, "Select one tree: several are selected");
}

void one_tree_reasons(Reasons& r, const ProjectState& state, const Derived& derived, const ViewState& view, const TreeRecord& tree) {
  const MatchRow* match = match_to_decide(derived, view);
  const TreeRow* row = derived.tree(view.selected_tree);
  const bool fate_to_confirm = row != nullptr && derived.doubt(view.selected_tree) != nullptr;
  const QueueRow* asked = derived.doubt(view.selected_tree);
  const bool answered = asked != nullptr && asked->decided && !asked->match && view.selected_stem.index < 0;
  r.unless(!answered, {review_accept, review_reject}, "This tree is decided on: click one of its stems to decide on a match of it");
  r.unless(match != nullptr || fate_to_confirm, {review_accept}, "This tree has no match to accept");
  const bool fate_in_doubt = match == nullptr && fate_to_confirm && tree.stems.size() >= 2;
  r.unless(!fate_in_doubt, {review_reject}, "The doubt is about the tree's fate: set it in the menu Review, or click a stem in its history first");
  r.unless(match != nullptr, {review_reject}, "This tree has no match to reject");
  r.unless(match == nullptr || match->state != MatchState::accepted, {review_accept}, "It is accepted already");
  r.unless(tree.stems.size() >= 2, {review_unlink}, "This tree was seen in one survey only: there is nothing to unlink");
  r.unless(derived.tables.inventories.size() >= 2, {review_link, review_swap, review_merge}, "Linking needs two aligned surveys");
  r.unless(tree.fate_by_hand.has_value(), {review_clear_fate}, "No fate was set by hand");
  for (const auto& [id, fate] : {std::pair{review_removed, Fate::removed}, {review_missed_earlier, Fate::missed_earlier}, {review_ingrowth, Fate::ingrowth}}) {
    const std::string contradicted = why_not_fate(state, view.selected_tree, fate);
    r.unless(contradicted.empty(), {id}, contradicted);
  }
  const StemRef first = unlink_target(state, view);
  const std::string why_not = first.index < 0 ? "This tree was seen in one survey only: there is nothing to split" : why_not_split(state, first);
  r.unless(why_not.empty(), {review_split}, why_not);
}

void tree_reasons(Reasons& r, const Project& project, const Derived& derived, const ViewState& view) {
  const ProjectState& state = project.state();
  r.unless(!derived.tables.trees.empty(), {export_run, export_report, export_preview_report, export_field_check, export_preview_field_check}, "Add inventories first: there is nothing to write yet");
  r.unless(!derived.tables.queue.empty(), {review_next, review_previous}, "No tree is in doubt");
  r.unless(!derived.tables.queue.empty(), {review_region}, "The queue is empty");
  r.unless(view.queue.hides_rows() || view.only_fate, {review_clear_filters}, "The queue is not filtered");
  r.unless(!state.trees.empty(), {tool_rectangle, tool_lasso}, "Add inventories first");
  r.unless(!derived.tables.queue.empty(), {export_field_check, export_preview_field_check}, "No tree is in doubt: there is nothing to check outside");
  if (!view.group.empty()) return group_reasons(r, derived, view);
  const auto tree = state.trees.find(view.selected_tree);
  const bool chosen = tree != state.trees.end();
  r.unless(chosen, {view_focus, review_accept, review_reject, review_link, review_unlink, review_swap, review_split, review_merge}, "Select a tree first");
  r.unless(chosen, fate_actions, "Select a tree first");
  if (chosen) one_tree_reasons(r, state, derived, view, tree->second);
}

}  // namespace

Availabilities availabilities(const Project& project, const Derived& derived, const ViewState& view, const WindowStatus& status) {
  Availabilities out;
  Reasons reasons(out);
  project_reasons(reasons, project, view, status);
  tree_reasons(reasons, project, derived, view);
  reasons.unless(derived.tables.inventories.size() >= 2, {view_blink, view_slide, view_before_after}, "Comparing needs two aligned surveys");
  return out;
}

}  // namespace stemwise::ui
