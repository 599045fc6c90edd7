#pragma once
#include <string>

#include "core/project/command.hpp"
#include "ui/view_state.hpp"

namespace stemwise {

/// What a click on a stem would do with the tool in hand: said before it is done, and done when it is clicked. `command` is
/// empty where nothing can be done; then `words` says why.
struct ClickEffect {
  StemRef from, to;        ///< the stems that are meant, of those that were pointed at
  std::string words;       ///< "Link 2018:12 and 2023:45; 2023:44 leaves T-00012"
  bool possible = false;
};

/// For the tools link, swap and merge; `from` is the stem that the tool began with.
ClickEffect effect_of_click(const ProjectState& state, ui::Tool tool, StemRef from, StemRef to);
/// Makes the command of a possible effect.
CommandPtr command_of(const ProjectState& state, ui::Tool tool, const ClickEffect& effect, EditStamp stamp);

}  // namespace stemwise
