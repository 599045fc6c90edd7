#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/project/command.hpp"

namespace stemwise {

/// Small changes of matches and trees that remember how to go back: the cost is that of what is touched, not of the
/// project. Trees lead: a tree's stems stay together, and matches say why.
class MatchEditor {
 public:
  explicit MatchEditor(ProjectState& state) : state_(state), next_tree_(state.next_tree), log_size_(state.edit_log.size()) {}

  const ProjectState& state() const { return state_; }
  void set_match(const StemPair& pair, std::optional<Match> match);
  void set_match_state(StemRef a, StemRef b, MatchState match_state);  ///< makes the match where there is none
  void set_tree(TreeId id, std::optional<TreeRecord> record);
  void note_edit(TreeId id, const EditStamp& stamp);
  /// Moves `stems` out of `from` into a tree of their own; the former pairs between both sides are rejected.
  TreeId split(TreeId from, const std::vector<StemRef>& stems, const std::vector<StemPair>& must_reject);
  void merge(TreeId into, TreeId from);
  /// Two stems of one inventory go to each other's tree: linked there, rejected here.
  void exchange(StemRef a, StemRef b);
  void log(const EditStamp& stamp, std::string what, std::string before, std::string after);

  /// How to undo all of it.
  struct Before {
    std::vector<std::pair<StemPair, std::optional<Match>>> matches;
    std::vector<std::pair<TreeId, std::optional<TreeRecord>>> trees;
    std::int64_t next_tree = 1;
    std::size_t log_size = 0;
  };
  Before take_before();
  static void restore(ProjectState& state, const Before& before);

 private:
  Match measured(StemRef a, StemRef b) const;
  void keep_joined(TreeId id);
  void receive(TreeId tree, StemRef gone, StemRef come);

  ProjectState& state_;
  Before before_;
  std::int64_t next_tree_;
  std::size_t log_size_;
};

/// "2018:1204": how a stem is called in labels and the log.
std::string stem_label(const ProjectState& state, StemRef stem);

}  // namespace stemwise
