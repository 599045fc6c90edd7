#pragma once
#include "core/project/project.hpp"
#include "ui/actions/action.hpp"
#include "ui/derived.hpp"
#include "ui/requests.hpp"
#include "ui/view_state.hpp"
#include "ui/window_status.hpp"

namespace stemwise::ui {

/// Everything a panel reads while one frame is drawn, and where it puts what the person asked for.
struct Frame {
  const Project& project;
  std::uint64_t revision;  ///< of the project; unique over all projects of this window
  const Derived& derived;  ///< may be of an earlier revision for a moment
  const WindowStatus& status;
  const Availabilities& available;
  ViewState& view;
  Requests& requests;

  const ProjectState& state() const { return project.state(); }
  const Tables& tables() const { return derived.tables; }
  bool can(ActionId id) const { return available[static_cast<std::size_t>(id)].enabled(); }
};

/// The colour of an inventory: its place by date, as the map has it.
Color inventory_color(const ProjectState& state, InventoryId id);
/// "2018:1204": how a stem is called by people.
std::string stem_label(const ProjectState& state, StemRef stem);
/// What people call an inventory: its year where every inventory has one of its own, else its name.
std::string survey_label(const ProjectState& state, InventoryId id);
/// The survey whose alignment is looked at: the selected one, or the last one that is not the reference. None without any.
InventoryId survey_to_compare(const ProjectState& state, const ViewState& view);
/// The stem that Unlink takes out: the selected one, else the tree's last sighting.
StemRef unlink_target(const ProjectState& state, const ViewState& view);
/// The match that Accept and Reject decide on: that of the selected stem, else that of the queue, else the tree's least certain
/// one. None where the doubt is about the tree's fate and no stem was chosen.
const MatchRow* match_to_decide(const Derived& derived, const ViewState& view);

}  // namespace stemwise::ui
