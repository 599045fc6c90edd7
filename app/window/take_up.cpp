#include "app/window/requests.hpp"

namespace stemwise {
namespace {

/// Nothing that is said, shown or chosen stays from the project before.
void begin_anew(WindowModel& m) {
  m.view.selected_tree = {};
  m.view.selected_stem = {};
  m.view.selected_inventory = m.document.state().reference;
  m.view.hidden.clear();
  m.view.only_fate.reset();
  m.view.group.clear();
  m.view.queue = {};
  m.view.tool = ui::Tool::select;
  m.view.underlays.clear();
  m.underlays = {};
  m.view.pairs.clear();
  m.view.ghost = m.view.before_after = m.view.slide = false;
  m.view.placement = {};
  m.previews.forget();
  m.status.placement.reset();
  m.status.fusion.reset();
  m.status.rules.reset();
  m.status.exporting.reset();
  m.status.reporting.reset();
  m.status.page.reset();
  m.walk = {};
  m.saved_at.reset();
  m.changed_elsewhere.reset();
  m.notices.clear();
  m.jobs.forget_finished();
}

void show_fitting_step(WindowModel& m) {
  const ProjectState& state = m.document.state();
  bool placed = false;
  for (const auto& inventory : state.inventories) placed = placed || (inventory->id != state.reference && state.is_placed(inventory->id));
  m.view.step = placed ? ui::Step::review : state.inventories.size() >= 2 ? ui::Step::align : ui::Step::inventories;
}

}  // namespace

void take_up(WindowModel& m, ProjectState state, const std::string& path, ProjectStamp stamp, bool saved) {
  remember_underlays(m);
  m.jobs.start<int>("The project of before", JobLane::tables,
                    [left = m.document.replace(std::move(state), path, std::move(stamp), saved)](const Progress&) mutable { return left.reset(), 0; }, [](int) { return JobVerdict{}; });
  begin_anew(m);
  show_fitting_step(m);
  restore_underlays(m);
}

}  // namespace stemwise
