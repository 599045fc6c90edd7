#include "ui/panels/align_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdlib>

#include "core/project/rough_pose_key.hpp"
#include "ui/panels/alignment_words.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

std::string setting(const Frame& frame, const std::string& key, const std::string& otherwise) {
  const auto it = frame.state().settings.find(key);
  return it == frame.state().settings.end() ? otherwise : it->second;
}

/// Switches a view of this survey on or off.
void toggle_for(Frame& frame, const Inventory& inventory, bool& shown) {
  shown = !shown || frame.view.selected_inventory != inventory.id;
  frame.view.selected_inventory = inventory.id;
}

}  // namespace

void AlignPanel::draw(Widgets& w, Frame& frame) {
  w.text("Align", TextRole::title);
  w.paragraph("Finds how the surveys lie on each other and which stem is which. No first guess is needed; decisions made by hand are kept.",
              TextRole::table, Tone::secondary);
  draw_run(w, frame);
  draw_settings(w, frame);
  w.section("Result");
  const ProjectState& state = frame.state();
  for (const auto& inventory : state.inventories) draw_result(w, frame, *inventory);
  bool placed = false;
  for (const auto& inventory : state.inventories) placed = placed || (inventory->id != state.reference && state.is_placed(inventory->id));
  w.gap(10);
  if (placed && w.button("align/next", "Go on to review", {.width = -1.0f, .key = "3"})) frame.requests.run(ActionId::step_review);
}

void AlignPanel::draw_run(Widgets& w, Frame& frame) {
  w.gap(8);
  const JobView* job = frame.status.running();
  if (job == nullptr) {
    w.action_button("align/run", ActionId::align_run, frame.available, frame.requests, {.primary = true, .width = -1.0f});
    draw_last_run(w, frame);
    return;
  }
  w.text(job->title, TextRole::strong);
  const Rect bar = w.next_rect(w.available_width(), w.px(8));
  w.progress_bar(bar, job->fraction);
  ImGui::Dummy({bar.width, bar.height});
  w.text(job->stage + (job->left_s ? ", " + duration_text(*job->left_s) + " left" : ""), TextRole::table, Tone::secondary);
  w.record_last("align/stage", job->stage);
  if (w.button("align/cancel", "Cancel", {.width = -1.0f})) frame.requests.emit(request::CancelJob{job->id});
}

/// A run that came to nothing says so where it was started.
void AlignPanel::draw_last_run(Widgets& w, const Frame& frame) {
  const auto& jobs = frame.status.jobs;
  if (jobs.empty() || !jobs.front().title.starts_with("Align ")) return;
  const JobView& job = jobs.front();
  const bool cancelled = job.state == JobView::State::cancelled;
  if (!cancelled && job.state != JobView::State::failed) return;
  w.paragraph(cancelled ? "Cancelled. Nothing was changed." : job.outcome, TextRole::table, cancelled ? Tone::secondary : Tone::warning);
  w.record_last("align/last_run", cancelled ? "cancelled" : job.outcome);
}

void AlignPanel::draw_settings(Widgets& w, Frame& frame) {
  if (!w.fold("align/settings", "Settings", settings_open_)) return;
  static const std::vector<std::string> presets{"auto", "plot", "route"};
  const std::string preset = setting(frame, "preset", "auto");
  int current = static_cast<int>(std::find(presets.begin(), presets.end(), preset) - presets.begin());
  w.text("Preset for frame folders", TextRole::table, Tone::secondary);
  if (w.combo("align/preset", presets, current)) frame.requests.emit(request::SetSetting{"preset", presets[static_cast<std::size_t>(current)]});
  bool accept = setting(frame, "accept_probable", "false") == "true";
  if (w.checkbox("align/accept_probable_setting", "Take probable poses as aligned", accept)) frame.requests.emit(request::SetSetting{"accept_probable", accept ? "true" : "false"});
  double seed = std::strtod(setting(frame, "seed", "0").c_str(), nullptr);
  w.text("Seed (the same seed gives the same result)", TextRole::table, Tone::secondary);
  w.number("align/seed", seed, "%.0f", w.px(120));
  if (ImGui::IsItemDeactivatedAfterEdit() && seed >= 0.0) frame.requests.emit(request::SetSetting{"seed", std::to_string(static_cast<std::uint64_t>(seed))});
}

void AlignPanel::draw_result(Widgets& w, Frame& frame, const Inventory& inventory) {
  const ProjectState& state = frame.state();
  const auto it = state.alignments.find(inventory.id);
  const bool reference = inventory.id == state.reference;
  w.gap(12);
  const Rect head = w.next_rect(w.available_width(), w.px(28));
  w.fill({head.x, head.y + w.px(6), w.px(4), w.px(16)}, inventory_color(state, inventory.id), w.px(2));
  if (w.area("align/survey/" + inventory.name, head, "")) frame.view.selected_inventory = inventory.id;
  w.text_in({head.x + w.px(12), head.y, head.width * 0.6f, head.height}, inventory.name, TextRole::strong, Tone::text);
  const std::string status = reference ? "reference" : it == state.alignments.end() ? "not aligned yet" : to_string(it->second.status);
  const bool bad = it != state.alignments.end() && (it->second.status == AlignmentStatus::failed || it->second.status == AlignmentStatus::probable);
  const bool good = !reference && it != state.alignments.end() && it->second.status == AlignmentStatus::aligned;
  w.text_in({head.x, head.y, head.width, head.height}, status == "failed" ? "refused" : status, TextRole::table, bad ? Tone::warning : good ? Tone::accent : Tone::secondary, Align::right);
  w.record("align/status/" + inventory.name, head, status);
  if (reference || it == state.alignments.end()) return;
  const InventoryAlignment& a = it->second;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  if (!a.reason.empty()) w.paragraph(sentence(a.reason), TextRole::table, Tone::warning);
  if (a.status == AlignmentStatus::aligned) {  // a proposed pose has matched nothing yet
    w.fact("align/overlap/" + inventory.name, "Overlap", percent_text(a.overlap, 1), "Matched stems over all stems that both surveys should have seen.");
    w.fact("align/matched/" + inventory.name, "Matched stems", count_text(a.matched));
    w.fact("align/residual/" + inventory.name, "Residual", residual_text(a.residual_rms_m), "Root mean square of the planar distances of matched stems.");
    w.fact("align/observed/" + inventory.name, "Observed", observed_words(a.observed), "Which degrees of freedom the data decided; the others stay zero.");
  }
  if (a.status == AlignmentStatus::aligned || a.status == AlignmentStatus::probable) {
    w.fact("align/second/" + inventory.name, "Second-best pose", second_best_words(a.acceptance));
    if (good) w.fact("align/probability/" + inventory.name, "Probability", fixed(a.acceptance.probability, 4), "That this is the right pose and no chance agreement.");
  }
  ImGui::PopStyleVar();
  if (a.status == AlignmentStatus::probable && w.button("align/accept/" + inventory.name, "Accept this pose", {.width = -1.0f})) {
    frame.requests.emit(request::AcceptProbable{inventory.id});
  }
  draw_looks(w, frame, inventory, a);
  draw_given_position(w, frame, inventory);
  if (bad && w.fold("align/rescue/" + inventory.name, "Help it along", rescue_open_)) rescue_.draw(w, frame, inventory);
}

/// What a person gave or accepted counts in every run, until it is taken back here.
void AlignPanel::draw_given_position(Widgets& w, Frame& frame, const Inventory& inventory) {
  const std::string key = rough_pose_key(inventory.id);
  const auto given = frame.state().settings.find(key);
  if (given == frame.state().settings.end() || given->second.empty()) return;
  w.gap(4);
  const std::string hint = "A position of " + inventory.name + " was given or accepted by hand and counts in every run. This takes it back; align again afterwards.";
  if (w.button("align/forget/" + inventory.name, "Forget the position given by hand", {.width = -1.0f, .tooltip = hint})) frame.requests.emit(request::SetSetting{key, ""});
}

/// Two looks at one alignment: as it was given and as it is now; and the second-best pose, or the one that waits for a decision.
void AlignPanel::draw_looks(Widgets& w, Frame& frame, const Inventory& inventory, const InventoryAlignment& a) {
  const bool aligned = a.status == AlignmentStatus::aligned, proposed = a.status == AlignmentStatus::probable;
  const bool has_ghost = proposed || a.second_best_pose;
  if (!aligned && !has_ghost) return;
  w.gap(6);
  const bool shown = frame.view.selected_inventory == inventory.id;
  const Rect row = w.next_rect(w.available_width(), w.px(30));
  const float half = 0.5f * (row.width - w.px(8));
  if (aligned && w.button_in({row.x, row.y, half, row.height}, "align/before_after/" + inventory.name, "Before, after", {.active = frame.view.before_after && shown, .key = "V", .tooltip = action(ActionId::view_before_after).help})) {
    toggle_for(frame, inventory, frame.view.before_after);
    frame.view.slide = frame.view.blink = false;
  }
  const Rect right = aligned ? Rect{row.x + half + w.px(8), row.y, half, row.height} : row;
  const std::string hint = proposed ? "The proposed pose: the stems of " + inventory.name + " hollow on the map" : "The stems of " + inventory.name + " a second time, hollow, where they would fit next best";
  if (has_ghost && w.button_in(right, "align/ghost/" + inventory.name, proposed ? "Show the proposed pose" : "Second best", {.active = frame.view.ghost && shown, .key = "G", .tooltip = hint})) toggle_for(frame, inventory, frame.view.ghost);
}

}  // namespace stemwise::ui
