#pragma once
#include "core/project/command.hpp"

namespace stemwise {

// Makers of the commands that move stems between trees as a whole; like those of commands.hpp they are kept for every
// later run. Each throws std::logic_error on apply where it has no meaning (see its `why_not_` question).

/// Two stems of one survey change places: each goes to the other's tree, and is no longer held to be its own.
CommandPtr swap_stems(StemRef a, StemRef b, EditStamp stamp);
/// Nothing, or why they cannot be swapped, as a sentence.
std::string why_not_swap(const ProjectState& state, StemRef a, StemRef b);

/// The stems of the tree from `first` on, by date, become a tree of their own.
CommandPtr split_tree(StemRef first, EditStamp stamp);
std::string why_not_split(const ProjectState& state, StemRef first);

/// The stems of both become one tree, which keeps the smaller id.
CommandPtr merge_trees(TreeId a, TreeId b, EditStamp stamp);
std::string why_not_merge(const ProjectState& state, TreeId a, TreeId b);

}  // namespace stemwise
