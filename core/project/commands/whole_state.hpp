#pragma once
#include <optional>
#include <string>
#include <utility>

#include "core/project/command.hpp"

namespace stemwise {

/// A command that touches much (an alignment, an inventory): it keeps the earlier state. Inventories are shared, so that
/// this costs the small records only. `Change` is a callable `void(ProjectState&)`, pure: the same state, the same change.
template <class Change>
class WholeStateCommand final : public Command {
 public:
  WholeStateCommand(std::string label, Change change) : label_(std::move(label)), change_(std::move(change)) {}
  void apply(ProjectState& state) override {
    ProjectState changed = state;
    change_(changed);  // a throw leaves the project as it was
    before_ = std::exchange(state, std::move(changed));
  }
  void revert(ProjectState& state) override { state = std::move(before_); }
  std::string label() const override { return label_; }

 private:
  std::string label_;
  Change change_;
  ProjectState before_;
};

template <class Change>
CommandPtr whole_state(std::string label, Change change) {
  return std::make_unique<WholeStateCommand<Change>>(std::move(label), std::move(change));
}

/// A command that sets one member of the state, found by `Access`: a callable `Value&(ProjectState&)`.
template <class Value, class Access>
class SetValueCommand final : public Command {
 public:
  SetValueCommand(std::string label, Value value, Access access)
      : label_(std::move(label)), value_(std::move(value)), access_(std::move(access)) {}
  void apply(ProjectState& state) override { std::swap(access_(state), value_); }
  void revert(ProjectState& state) override { std::swap(access_(state), value_); }
  std::string label() const override { return label_; }

 private:
  std::string label_;
  Value value_;
  Access access_;
};

template <class Value, class Access>
CommandPtr set_value(std::string label, Value value, Access access) {
  return std::make_unique<SetValueCommand<Value, Access>>(std::move(label), std::move(value), std::move(access));
}

}  // namespace stemwise
