#include "app/rough_poses.hpp"
#include "app/window/requests.hpp"
#include "core/project/commands.hpp"

namespace stemwise {
namespace {

namespace request = ui::request;

/// One overload per request.
struct Answer {
  WindowModel& m;

  void operator()(const request::Run& r) const { run_action(m, r.action); }
  void operator()(const request::Explain& r) const { m.notices.add(Severity::note, std::string(ui::action(r.action).label) + ": " + r.why_not); }
  void operator()(const request::SelectTree& r) const { select_tree(m, r.tree, r.fly, r.stem); }
  void operator()(const request::AddInventories& r) const { add_inventories(m, r.paths, r.ask); }
  void operator()(const request::ImportEdit& r) const { edit_import(m, r); }
  void operator()(const request::ImportFinish& r) const { finish_import(m, r.take); }
  void operator()(const request::AddUnderlays& r) const { add_underlays(m, r.paths); }
  void operator()(const request::RemoveUnderlay& r) const { remove_underlay(m, r.id); }
  void operator()(const request::OpenProject& r) const {
    leave_then(m, [&model = m, path = r.path] { open_project(model, path); });
  }
  void operator()(const request::SaveProject& r) const { save_as(m, r.path); }
  void operator()(const request::SetDate& r) const { m.execute(set_inventory_date(r.inventory, r.date)); }
  void operator()(const request::AcceptProbable& r) const { accept_pose_of(m, r.inventory); }
  void operator()(const request::LinkStems& r) const { use_tool(m, ui::Tool::link, r.a, r.b); }
  void operator()(const request::SelectGroup& r) const { select_group(m, r.trees); }
  void operator()(const request::RejectPair& r) const { m.execute(reject_match(r.a, r.b, stamp_now())); }
  void operator()(const request::AcceptPair& r) const { m.execute(accept_match(r.a, r.b, stamp_now())); }
  void operator()(const request::SetFate& r) const { m.execute(set_fate(r.tree, r.fate, stamp_now())); }
  void operator()(const request::SetNote& r) const { m.execute(set_tree_note(r.tree, r.note, stamp_now(r.note))); }
  void operator()(const request::SetFusion& r) const { m.execute(set_fusion_policy(r.policy)); }
  void operator()(const request::ChooseSource& r) const { m.execute(choose_source(r.tree, r.attribute, r.source)); }
  void operator()(const request::ChooseRules& r) const { choose_rules(m, r.pack); }
  void operator()(const request::ReadRules& r) const { read_own_rules(m, r.path); }
  void operator()(const request::SetDbhError& r) const { m.execute(set_dbh_error(r.inventory, r.error_m)); }
  void operator()(const request::EstimateCoverage& r) const { estimate_coverage_again(m, r.inventory); }
  void operator()(const request::AlignByPairs&) const { align_by_pairs(m); }
  void operator()(const request::Shape& r) const { r.close ? m.viewport.shape().close() : m.viewport.shape().take_back(); }
  void operator()(const request::WriteFieldCheck& r) const { write_field_check_sheet(m, r); }
  void operator()(const request::SaveChart& r) const { save_chart(m, r); }
  void operator()(const request::SetGeoreference& r) const { m.execute(set_georeference(r.georeference)); }
  void operator()(const request::SetSetting& r) const { m.execute(set_setting(r.key, r.value)); }
  void operator()(const request::GoToHistory& r) const {
    while (m.document.project().history_position() > r.position && m.document.project().can_undo()) m.document.undo();
    while (m.document.project().history_position() < r.position && m.document.project().can_redo()) m.document.redo();
  }
  void operator()(const request::CancelJob& r) const { m.jobs.cancel(r.job); }
  void operator()(const request::DismissNotice& r) const { m.notices.dismiss(r.notice); }
  void operator()(const request::DismissNotices&) const { m.notices.clear(); }
  void operator()(const request::NoticeChoice& r) const {
    if (const auto chosen = m.notices.choose(r.notice, r.choice)) chosen();
  }
  void operator()(const request::AnswerQuestion& r) const { answer_question(m, r.answer); }
  void operator()(const request::Recover& r) const { answer_recovery(m, r.answer); }
  void operator()(const request::Leave& r) const { answer_leave(m, r.save); }
  void operator()(const request::RoughPose& r) const {
    m.execute(keep_rough_pose(m.document.state(), {r.inventory, r.x_m, r.y_m, radians(r.yaw_deg), r.radius_m}, stamp_now()));
    run_alignment(m);
  }
  void operator()(const request::Export& r) const { export_layer(m, r); }
  void operator()(const request::WriteReport& r) const { write_report(m, r); }
  void operator()(const request::ShowChart& r) const {
    std::vector<TreeId> trees = m.charts.show(r, m.document, m.view, m.scale);
    if (trees.size() == 1 && !r.adds) return select_tree(m, trees.front(), true);
    if (trees.empty()) return;
    if (r.adds) trees.insert(trees.end(), m.view.group.begin(), m.view.group.end());
    select_group(m, std::move(trees));
  }
  void operator()(const request::Pointer& r) const {
    const auto pick = m.viewport.pointer(r, m.view);
    const bool takes_places = m.view.tool == ui::Tool::measure || m.view.tool == ui::Tool::lasso || m.view.tool == ui::Tool::coverage;
    if (const auto corners = m.viewport.shape().take()) finish_shape(m, *corners, r.ctrl);
    if (r.clicked && !takes_places) {
      const bool adds = r.ctrl && pick && pick->tree && m.view.tool == ui::Tool::select;
      const bool waits_for_stem = m.view.tool == ui::Tool::link || m.view.tool == ui::Tool::swap || m.view.tool == ui::Tool::merge || m.view.tool == ui::Tool::pair;
      if (adds) toggle_in_group(m, pick->tree);
      else if (pick) click_stem(m, *pick);
      else if (!waits_for_stem) select_tree(m, TreeId{}, false);
    }
    if (auto trees = m.viewport.take_selection()) {
      if (r.ctrl) trees->insert(trees->end(), m.view.group.begin(), m.view.group.end());
      select_group(m, std::move(*trees));
      m.view.tool = ui::Tool::select;
    }
    if (r.double_clicked && m.view.selected_tree) m.viewport.fly_to(m.view.selected_tree, !m.view.reduce_motion);  // the first click selected it
  }
};

}  // namespace

void answer(WindowModel& model, const ui::Request& request) { std::visit(Answer{model}, request); }

}  // namespace stemwise
