#pragma once
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/project/commands/match_editor.hpp"

namespace stemwise {

/// A person's edit: `change` works through the editor, which remembers how to go back. Its label is what it writes into the
/// edit log first, known once it was applied.
class EditCommand final : public Command {
 public:
  using Change = std::function<void(MatchEditor&)>;
  explicit EditCommand(Change change) : change_(std::move(change)) {}
  void apply(ProjectState& state) override {
    const std::size_t logged = state.edit_log.size();
    MatchEditor editor(state);
    try {
      change_(editor);
    } catch (...) {
      MatchEditor::restore(state, editor.take_before());
      throw;
    }
    before_ = editor.take_before();
    if (state.edit_log.size() > logged) label_ = state.edit_log[logged].what;
  }
  void revert(ProjectState& state) override { MatchEditor::restore(state, before_); }
  std::string label() const override { return label_; }

 private:
  std::string label_;
  Change change_;
  MatchEditor::Before before_;
};

inline CommandPtr edit(EditCommand::Change change) {
  return std::make_unique<EditCommand>(std::move(change));
}

/// Throws where the stem belongs to no tree yet.
inline TreeId tree_with(const ProjectState& state, StemRef stem) {
  const TreeId id = state.tree_of(stem);
  if (!id) throw std::logic_error("the stem's inventory is not aligned, so it belongs to no tree yet");
  return id;
}

}  // namespace stemwise
