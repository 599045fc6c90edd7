#include "core/project/project.hpp"

#include <utility>

namespace stemwise {

void Project::execute(CommandPtr command) {
  command->apply(state_);  // throws before it has changed anything; then history stays as it was
  history_.erase(history_.begin() + static_cast<std::ptrdiff_t>(position_), history_.end());
  if (saved_position_ && *saved_position_ > position_) saved_position_.reset();
  history_.push_back(std::move(command));
  ++position_;
  ++revision_;
}

void Project::undo() {
  if (!can_undo()) return;
  history_[--position_]->revert(state_);
  ++revision_;
}

void Project::redo() {
  if (!can_redo()) return;
  history_[position_++]->apply(state_);
  ++revision_;
}

std::string Project::undo_label() const { return can_undo() ? history_[position_ - 1]->label() : ""; }
std::string Project::redo_label() const { return can_redo() ? history_[position_]->label() : ""; }

std::vector<std::string> Project::history_labels() const {
  std::vector<std::string> labels;
  for (const CommandPtr& command : history_) labels.push_back(command->label());
  return labels;
}

}  // namespace stemwise
