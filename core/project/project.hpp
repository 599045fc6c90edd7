#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/project/command.hpp"

namespace stemwise {

/// The project: its state, the only door through which it changes, and its history (unlimited undo and redo).
class Project {
 public:
  Project() = default;
  explicit Project(ProjectState state) : state_(std::move(state)) {}

  const ProjectState& state() const { return state_; }
  /// Goes up with every change, undo and redo too: whoever caches compares it.
  std::uint64_t revision() const { return revision_; }

  void execute(CommandPtr command);
  bool can_undo() const { return position_ > 0; }
  bool can_redo() const { return position_ < history_.size(); }
  void undo();
  void redo();
  std::string undo_label() const;  ///< empty when there is nothing to undo
  std::string redo_label() const;
  /// Labels oldest first; entries from `history_position()` on have been undone.
  std::vector<std::string> history_labels() const;
  std::size_t history_position() const { return position_; }

  void mark_saved() { saved_position_ = position_; }
  bool is_dirty() const { return saved_position_ != position_; }

 private:
  ProjectState state_;
  std::uint64_t revision_ = 0;
  std::vector<CommandPtr> history_;
  std::size_t position_ = 0;
  std::optional<std::size_t> saved_position_ = 0;  ///< nothing when the saved state can no longer be reached
};

}  // namespace stemwise
