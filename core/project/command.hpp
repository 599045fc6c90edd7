#pragma once
#include <memory>
#include <string>

#include "core/project/project_state.hpp"

namespace stemwise {

/// One small reversible change of the project. Law (tested for every command): apply, revert, apply equals apply; revert
/// restores equality. `apply` throws std::logic_error only for a programmer's error, before it has changed anything.
class Command {
 public:
  virtual ~Command() = default;
  virtual void apply(ProjectState& state) = 0;
  virtual void revert(ProjectState& state) = 0;
  virtual std::string label() const = 0;  ///< "Link 2018:1204 to T-00412", sentence case, for Undo's menu entry
};

using CommandPtr = std::unique_ptr<Command>;

/// Who does it, when, and why: stamped into the edit log by commands that a person gives.
struct EditStamp {
  std::string author;
  std::string time_utc;
  std::string note;
};

}  // namespace stemwise
