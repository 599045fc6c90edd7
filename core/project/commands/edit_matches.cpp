#include <algorithm>
#include <stdexcept>

#include "core/project/commands.hpp"
#include "core/project/commands/edit_command.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {
namespace {

std::string pair_label(const ProjectState& state, StemRef a, StemRef b) {
  return stem_label(state, a) + " and " + stem_label(state, b);
}

std::string state_before(const ProjectState& state, StemRef a, StemRef b) {
  const auto match = state.matches.find(ordered(a, b));
  return match == state.matches.end() ? "no match" : to_string(match->second.state);
}

/// "Mark T-00412 as removed".
std::string fate_edit_label(TreeId tree, std::optional<Fate> fate) {
  if (!fate) return "Clear the fate of " + tree_label(tree);
  return "Mark " + tree_label(tree) + " as " + fate_in_sentence(*fate);
}

/// The stems of the tree from `b` on by date: what goes with `b` when it is not the same tree as the earlier `a`.
std::vector<StemRef> side_of_later(const ProjectState& state, const TreeRecord& tree, StemRef a, StemRef b) {
  const std::vector<InventoryId> order = state.by_date();
  const auto rank = [&](StemRef stem) { return std::find(order.begin(), order.end(), stem.inventory) - order.begin(); };
  const auto cut = std::max(rank(a), rank(b));
  std::vector<StemRef> later;
  for (const StemRef& stem : tree.stems)
    if (rank(stem) >= cut) later.push_back(stem);
  return later;
}

/// The stem of `inventory` in the tree, other than `keep`, leaves it.
void make_room(MatchEditor& editor, TreeId tree, InventoryId inventory, StemRef keep, StemRef against) {
  for (const StemRef& stem : std::vector<StemRef>(editor.state().trees.at(tree).stems))
    if (stem.inventory == inventory && stem != keep) editor.split(tree, {stem}, {ordered(stem, against)});
}

void link(MatchEditor& editor, StemRef a, StemRef b) {
  const ProjectState& state = editor.state();
  if (a.inventory == b.inventory) throw std::logic_error("two stems of one inventory cannot be one stem");
  const TreeId tree_a = tree_with(state, a), tree_b = tree_with(state, b);
  if (tree_a != tree_b) {
    make_room(editor, tree_a, b.inventory, b, a);
    make_room(editor, tree_b, a.inventory, a, b);
    for (const StemRef& stem : std::vector<StemRef>(state.trees.at(tree_b).stems))
      if (stem != b) {
        const auto& others = state.trees.at(tree_a).stems;
        const auto clash = std::find_if(others.begin(), others.end(), [&](StemRef o) { return o.inventory == stem.inventory; });
        if (clash != others.end()) editor.split(tree_b, {stem}, {ordered(stem, a)});
      }
    const std::vector<StemRef> of_a = state.trees.at(tree_a).stems, of_b = state.trees.at(tree_b).stems;
    editor.merge(std::min(tree_a, tree_b), std::max(tree_a, tree_b));
    for (const StemRef& one : of_a)  // the tree that the person sees, whatever a later run thinks of its parts
      for (const StemRef& other : of_b) editor.set_match_state(one, other, MatchState::linked);
  }
  editor.set_match_state(a, b, MatchState::linked);
}

}  // namespace

CommandPtr accept_match(StemRef a, StemRef b, EditStamp stamp) {
  return edit([=](MatchEditor& editor) {
    if (tree_with(editor.state(), a) != tree_with(editor.state(), b)) throw std::logic_error("only a match can be accepted");
    editor.log(stamp, "Accept " + pair_label(editor.state(), a, b), state_before(editor.state(), a, b), "accepted");
    editor.set_match_state(a, b, MatchState::accepted);
    editor.note_edit(editor.state().tree_of(a), stamp);
  });
}

CommandPtr reject_match(StemRef a, StemRef b, EditStamp stamp) {
  return edit([=](MatchEditor& editor) {
    const ProjectState& state = editor.state();
    const TreeId tree = tree_with(state, a);
    editor.log(stamp, "Reject " + pair_label(state, a, b), state_before(state, a, b), "rejected");
    if (tree == tree_with(state, b)) {
      const TreeId other = editor.split(tree, side_of_later(state, state.trees.at(tree), a, b), {ordered(a, b)});
      editor.note_edit(other, stamp);
    } else {
      editor.set_match_state(a, b, MatchState::rejected);
    }
    editor.note_edit(tree, stamp);
  });
}

CommandPtr link_stems(StemRef a, StemRef b, EditStamp stamp) {
  return edit([=](MatchEditor& editor) {
    editor.log(stamp, "Link " + pair_label(editor.state(), a, b), state_before(editor.state(), a, b), "linked");
    link(editor, a, b);
    editor.note_edit(editor.state().tree_of(a), stamp);
  });
}

CommandPtr unlink_stem(StemRef stem, EditStamp stamp) {
  return edit([=](MatchEditor& editor) {
    const ProjectState& state = editor.state();
    const TreeId tree = tree_with(state, stem);
    std::vector<StemPair> apart;
    for (const StemRef& other : state.trees.at(tree).stems)
      if (other != stem) apart.push_back(ordered(stem, other));
    if (apart.empty()) throw std::logic_error("the stem is linked to nothing");
    editor.log(stamp, "Unlink " + stem_label(state, stem), tree_label(tree), "a tree of its own");
    const TreeId alone = editor.split(tree, {stem}, apart);
    editor.note_edit(alone, stamp);
    editor.note_edit(tree, stamp);
  });
}

CommandPtr set_fate(TreeId tree, std::optional<Fate> fate, EditStamp stamp) {
  return edit([=](MatchEditor& editor) {
    TreeRecord record = editor.state().trees.at(tree);
    const std::string before = record.fate_by_hand ? fate_label(*record.fate_by_hand) : "automatic";
    editor.log(stamp, fate_edit_label(tree, fate), before, fate ? fate_label(*fate) : "automatic");
    record.fate_by_hand = fate;
    record.edited_by = stamp.author;
    editor.set_tree(tree, std::move(record));
  });
}

std::string why_not_fate(const ProjectState& state, TreeId tree, Fate fate) {
  std::vector<InventoryId> surveys = state.by_date();
  std::erase_if(surveys, [&](InventoryId id) { return !state.is_placed(id); });
  const auto record = state.trees.find(tree);
  if (record == state.trees.end() || surveys.size() < 2) return "Fates come with the second aligned survey";
  const auto seen = [&](InventoryId id) { return std::any_of(record->second.stems.begin(), record->second.stems.end(), [&](StemRef stem) { return stem.inventory == id; }); };
  const auto name = [&](InventoryId id) { return state.find(id)->name; };
  const InventoryId first = surveys.front(), before = surveys[surveys.size() - 2], last = surveys.back();
  if (fate == Fate::removed && seen(last)) return "It was found in " + name(last) + ", the last survey: it is not gone";
  if (fate != Fate::ingrowth && fate != Fate::missed_earlier) return "";
  if (seen(before) && seen(last)) return "It was found in " + name(before) + " and in " + name(last) + ": between them it is neither new nor missed";
  if (seen(first)) return "It was found in " + name(first) + ", the first survey: it is neither new nor was it missed before";
  return "";
}

CommandPtr log_decision(std::string what, std::string before, std::string after, EditStamp stamp) {
  return edit([=](MatchEditor& editor) { editor.log(stamp, what, before, after); });
}

CommandPtr set_tree_note(TreeId tree, std::string note, EditStamp stamp) {
  return edit([=](MatchEditor& editor) {
    TreeRecord record = editor.state().trees.at(tree);
    editor.log(stamp, "Note on " + tree_label(tree), record.note, note);
    record.note = note;
    record.edited_by = stamp.author;
    editor.set_tree(tree, std::move(record));
  });
}

}  // namespace stemwise
