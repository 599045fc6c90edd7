#pragma once
#include "core/project/project.hpp"
#include "ui/actions/action.hpp"
#include "ui/derived.hpp"
#include "ui/view_state.hpp"
#include "ui/window_status.hpp"

namespace stemwise::ui {

/// Which actions can be run now, and why the others cannot.
Availabilities availabilities(const Project& project, const Derived& derived, const ViewState& view, const WindowStatus& status);

}  // namespace stemwise::ui
