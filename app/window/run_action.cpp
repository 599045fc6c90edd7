#include <algorithm>
#include <functional>

#include "app/window/requests.hpp"
#include "core/project/commands.hpp"

namespace stemwise {
namespace {

using ui::ActionId;
using enum ui::ActionId;

void toggle(bool& value) { value = !value; }

bool run_file_action(WindowModel& m, ActionId action) {
  switch (action) {
    case file_new: leave_then(m, [&m] { new_project(m); }); return true;
    case file_open: leave_then(m, [&m] { m.view.dialog = ui::Dialog::open_project; }); return true;
    case file_add: m.view.dialog = ui::Dialog::add_inventories; return true;
    case file_import: m.view.dialog = ui::Dialog::import_inventories; return true;
    case file_underlay: m.view.dialog = ui::Dialog::add_underlay; return true;
    case file_demo: leave_then(m, [&m] { add_demo(m); }); return true;
    case file_save: m.leaves_after_saving = false; save(m); return true;
    case file_save_as: m.leaves_after_saving = false; m.view.dialog = ui::Dialog::save_project; return true;
    case file_quit: quit(m); return true;
    default: return false;
  }
}

/// The tree that was selected may be gone with the change: then the one that its stem belongs to now.
void keep_selection(WindowModel& m) {
  if (!m.view.selected_tree || m.document.state().trees.contains(m.view.selected_tree)) return;
  m.view.selected_tree = m.document.state().tree_of(m.view.selected_stem);
}

/// A change that can make another survey the reference.
void change_frame(WindowModel& m, CommandPtr change) {
  const bool had_place = m.document.state().georeference.kind != GeoreferenceKind::none;
  m.execute(std::move(change));
  if (!had_place || m.document.state().georeference.kind != GeoreferenceKind::none || m.document.is_empty()) return;
  m.notices.add(Severity::warning, "The project has no place on the earth any more",
                {Issue{Severity::warning, "", 0, "", "its georeference was that of the former reference's coordinates", "Place it again in step 4, or undo."}});
}

bool run_edit_action(WindowModel& m, ActionId action) {
  switch (action) {
    case edit_undo: m.document.undo(); keep_selection(m); return true;
    case edit_redo: m.document.redo(); keep_selection(m); return true;
    case edit_history: m.view.dialog = ui::Dialog::history; return true;
    case edit_coverage: start_shape(m, ui::Tool::coverage); m.view.mode = ui::ViewMode::map; return true;
    case edit_make_reference: change_frame(m, set_reference(m.view.selected_inventory)); return true;
    case edit_remove_inventory: change_frame(m, remove_inventory(m.view.selected_inventory)); return true;
    case align_run: run_alignment(m); return true;
    case align_cancel:
      if (const ui::JobView* job = m.status.running()) m.jobs.cancel(job->id);
      return true;
    case align_accept_probable: accept_pose_of(m, m.view.selected_inventory); return true;
    default: return false;
  }
}

bool run_view_action(WindowModel& m, ActionId action) {
  ui::ViewState& v = m.view;
  switch (action) {
    case view_mode: v.mode = v.mode == ui::ViewMode::map ? ui::ViewMode::space : ui::ViewMode::map; return true;
    case view_fit: m.viewport.fit(); return true;
    case view_focus: m.viewport.fly_to(v.selected_tree, !v.reduce_motion); return true;
    case view_blink: toggle(v.blink); v.slide = v.before_after = false; return true;
    case view_slide: toggle(v.slide); v.blink = v.before_after = false; return true;
    case view_before_after: toggle(v.before_after); v.blink = v.slide = false; return true;
    case view_ghost: toggle(v.ghost); return true;
    case view_links: toggle(v.layers.links); return true;
    case view_residuals: toggle(v.layers.residuals); return true;
    case view_coverage: toggle(v.layers.coverage); return true;
    case view_grid: toggle(v.layers.grid); return true;
    case view_labels: toggle(v.layers.labels); return true;
    case view_underlays: toggle(v.layers.underlays); return true;
    case view_left: toggle(v.panels.show_left); return true;
    case view_right: toggle(v.panels.show_right); return true;
    case view_bottom: toggle(v.panels.show_bottom); return true;
    case view_theme: v.theme = v.theme == ui::ThemeName::light ? ui::ThemeName::dark : ui::ThemeName::light; return true;
    case view_reduce_motion: toggle(v.reduce_motion); return true;
    case view_zoom_in: v.zoom_percent = std::min(m.status.most_zoom_percent, v.zoom_percent + 10.0); return true;
    case view_zoom_out: v.zoom_percent = std::max(80.0, std::min(m.status.most_zoom_percent, v.zoom_percent) - 10.0); return true;
    case tool_select: v.tool = ui::Tool::select; return true;
    case tool_rectangle: v.tool = v.tool == ui::Tool::rectangle ? ui::Tool::select : ui::Tool::rectangle; return true;
    case tool_lasso: start_shape(m, ui::Tool::lasso); return true;
    case tool_measure:
      v.tool = v.tool == ui::Tool::measure ? ui::Tool::select : ui::Tool::measure;
      m.viewport.forget_measure();
      return true;
    case help_palette: v.dialog = ui::Dialog::palette; return true;
    case help_keys: v.dialog = ui::Dialog::keys; return true;
    case help_about: v.dialog = ui::Dialog::about; return true;
    default: return false;
  }
}

void show_section(WindowModel& m, ui::ReportSection section) {
  m.view.step = ui::Step::report;
  m.view.panels.show_right = true;
  m.view.wanted_section = section;
}

void look_at_pages(WindowModel& m, ui::PrintedSheet sheet) {
  m.view.page.sheet = sheet;
  m.view.page.page = 0;
  m.view.dialog = ui::Dialog::pages;
}

/// A decision, and the way to the next tree in doubt where the person wants that.
void decide(WindowModel& m, const std::function<void()>& decision) {
  const QueueRow* doubt = m.document.derived().doubt(m.view.selected_tree);
  const bool asked = m.view.step == ui::Step::review && m.view.group.empty() && doubt != nullptr && !doubt->decided;
  decision();
  if (m.view.goes_on && asked) go_to_doubtful(m, true);
}

bool run_review_action(WindowModel& m, ActionId action) {
  switch (action) {
    case review_next: go_to_doubtful(m, true); return true;
    case review_previous: go_to_doubtful(m, false); return true;
    case review_go_on: toggle(m.view.goes_on); return true;
    case review_accept: decide(m, [&m] { accept_selected(m); }); return true;
    case review_reject: decide(m, [&m] { reject_selected(m); }); return true;
    case review_link: start_tool(m, ui::Tool::link); return true;
    case review_swap: start_tool(m, ui::Tool::swap); return true;
    case review_merge: start_tool(m, ui::Tool::merge); return true;
    case review_split: split_selected(m); return true;
    case review_region: toggle_queue_region(m); return true;
    case review_clear_filters: m.view.queue = {}; m.view.only_fate.reset(); return true;
    case review_unlink: decide(m, [&m] { unlink_selected(m); }); return true;
    case review_dead: decide(m, [&m] { set_selected_fate(m, Fate::dead); }); return true;
    case review_removed: decide(m, [&m] { set_selected_fate(m, Fate::removed); }); return true;
    case review_missed_earlier: decide(m, [&m] { set_selected_fate(m, Fate::missed_earlier); }); return true;
    case review_ingrowth: decide(m, [&m] { set_selected_fate(m, Fate::ingrowth); }); return true;
    case review_clear_fate: set_selected_fate(m, std::nullopt); return true;
    case export_preview_report: look_at_pages(m, ui::PrintedSheet::report); return true;
    case export_preview_field_check: look_at_pages(m, ui::PrintedSheet::field_check); return true;
    case export_run: show_section(m, ui::ReportSection::export_layer); return true;
    case export_report: show_section(m, ui::ReportSection::report); return true;
    case export_field_check: show_section(m, ui::ReportSection::field_check); return true;
    default: return false;
  }
}

}  // namespace

void run_action(WindowModel& m, ActionId action) {
  if (run_file_action(m, action) || run_edit_action(m, action) || run_view_action(m, action) || run_review_action(m, action)) return;
  if (action >= heat_density && action <= heat_residual) {
    const auto wanted = static_cast<ui::Heat>(static_cast<int>(action) - static_cast<int>(heat_density) + 1);
    m.view.heat = m.view.heat == wanted ? ui::Heat::none : wanted;
  } else if (action >= color_inventory && action <= color_times_seen) {
    m.view.color_by = static_cast<ui::ColorBy>(static_cast<int>(action) - static_cast<int>(color_inventory));
  } else if (action >= step_inventories && action <= step_report) {
    m.view.step = static_cast<ui::Step>(static_cast<int>(action) - static_cast<int>(step_inventories) + 1);
  }
}

}  // namespace stemwise
