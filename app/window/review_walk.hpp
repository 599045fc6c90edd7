#pragma once
#include <optional>
#include <set>
#include <vector>

#include "core/survey/tables.hpp"

namespace stemwise {

/// The walk through the review queue by N and P. It remembers the row that it stands on by that row's place in the order of
/// doubt, so that it goes on from there whatever a decision does to the row and to its tree.
class ReviewWalk {
 public:
  /// The person looks at this row now. `anew`: was sent there and did not come by N; rows seen before count again.
  void stand_on(const QueueRow& row, bool anew);
  /// The tree was decided on: a new question about it may come in its turn.
  void decided(TreeId tree) { visited_.erase(tree); }

  /// The most doubtful undecided row after this one that was not visited; after the last one from the top again. `queue`: the
  /// most doubtful first. None when nothing is undecided.
  std::optional<std::size_t> next(const std::vector<QueueRow>& queue);
  /// The undecided row before this one; before the first one the last.
  std::optional<std::size_t> previous(const std::vector<QueueRow>& queue) const;

 private:
  struct Place {
    double doubt = 0.0;
    bool about_fate = false;  ///< among equal doubts those about a match come first
    TreeId tree;
    bool is_before(const Place& other) const;
  };
  static Place place_of(const QueueRow& row) { return {row.doubt, !row.match.has_value(), row.tree}; }

  std::optional<Place> place_;
  std::set<TreeId> visited_;
};

}  // namespace stemwise
