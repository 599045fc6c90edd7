#include "ui/panels/report_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "ui/text/format.hpp"

namespace stemwise::ui {

void ReportPanel::start_paths(const Frame& frame) {
  const std::filesystem::path folder = frame.status.project_folder;
  const std::string title = frame.status.project_title.empty() ? "stemwise" : frame.status.project_title;
  export_.propose_path(folder.string(), title);
  const auto propose = [](std::string& field, std::string& proposed, const std::string& path) {
    if (field.empty() || field == proposed) field = path;
    proposed = path;
  };
  propose(report_path_, proposed_report_, (folder / (title + "-growth.html")).string());
  propose(check_path_, proposed_check_, (folder / (title + "-field-check.pdf")).string());
}

void ReportPanel::draw(Widgets& w, Frame& frame) {
  start_paths(frame);
  w.text("Report and export", TextRole::title);
  w.gap(4);
  if (is_section_open(w, frame, ReportSection::export_layer, "report/open_export", "Export", export_open_)) export_.draw(w, frame);
  w.gap(6);
  if (is_section_open(w, frame, ReportSection::rules, "report/open_rules", "Implausible growth", rules_open_)) rules_.draw(w, frame);
  w.gap(6);
  if (is_section_open(w, frame, ReportSection::report, "report/open_report", "Growth report", report_open_)) draw_report(w, frame);
  w.gap(6);
  if (is_section_open(w, frame, ReportSection::field_check, "report/open_check", "Field check sheet", check_open_)) draw_field_check(w, frame);
}

/// Its head. A section that was asked for opens and comes to the top; the second frame knows how far down it reaches.
bool ReportPanel::is_section_open(Widgets& w, Frame& frame, ReportSection section, const char* path, const char* label, bool& open) {
  const bool wanted = frame.view.wanted_section == section;
  if (wanted) open = true;
  const float top = ImGui::GetCursorPosY();
  w.fold(path, label, open);
  if (!wanted) return open;
  ImGui::SetScrollY(top - w.px(8));
  if (++frames_wanted_ < 3) return open;
  frames_wanted_ = 0;
  frame.view.wanted_section = ReportSection::none;
  return open;
}

void ReportPanel::draw_report(Widgets& w, Frame& frame) {
  w.paragraph("A file ending in .html, .pdf, .xlsx or .csv.", TextRole::caption, Tone::secondary);
  if (w.path_field("report/path", report_path_, "report/browse")) frame.view.dialog = Dialog::report_path;
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in({row.x, row.y, row.width * 0.6f, row.height}, "Area, ha", TextRole::body, Tone::secondary);
  ImGui::SetCursorScreenPos({row.x + row.width * 0.62f, row.y});
  w.number("report/area", frame.view.report_area_ha, "%.3f", 0.0f, "of the coverage");
  draw_contents(w, frame);
  w.gap(6);
  const std::string& no_trees = frame.available[static_cast<std::size_t>(ActionId::export_report)].why_not;
  const std::string why_not = !no_trees.empty() ? no_trees : frame.view.report_area_ha < 0.0 ? "An area is more than 0" : "";
  w.action_button("report/look", ActionId::export_preview_report, frame.available, frame.requests, {.width = -1.0f});
  if (w.button("report/run", "Write the report", {.width = -1.0f, .why_not = why_not})) frame.requests.emit(request::WriteReport{report_path_, frame.view.report_area_ha});
}

/// What would stand on the cover and in the sections.
void ReportPanel::draw_contents(Widgets& w, const Frame& frame) {
  const std::optional<ReportPreview>& preview = frame.status.reporting;
  if (!preview) {  // as high as what comes: the button below must not move away from the mouse
    w.text("Working it out…", TextRole::table, Tone::secondary);
    ImGui::Dummy({1.0f, w.px(5 * 24 + 28) - w.line_height(TextRole::table)});
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (const auto& [label, value, detail] : preview->figures) w.fact("report/figure/" + label, sentence(label), value, detail);
  ImGui::PopStyleVar();
  w.record_last("report/contents", std::to_string(preview->sections.size()));
  if (!w.fold("report/sections", plural(static_cast<std::int64_t>(preview->sections.size()), "section", "sections"), contents_open_)) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (const auto& [title, content] : preview->sections) w.fact("report/section/" + title, title, content);
  ImGui::PopStyleVar();
}

void ReportPanel::draw_field_check(Widgets& w, Frame& frame) {
  w.paragraph("Doubtful trees with distance and azimuth from the three nearest sure trees, to take outside. A file ending in .pdf, .html, .gpx, .csv or .xlsx.", TextRole::caption, Tone::secondary);
  if (w.path_field("check/path", check_path_, "check/browse")) frame.view.dialog = Dialog::field_check_path;
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in({row.x, row.y, row.width * 0.6f, row.height}, "Trees at most", TextRole::body, Tone::secondary);
  ImGui::SetCursorScreenPos({row.x + row.width * 0.62f, row.y});
  w.number("check/most", frame.view.most_field_checks, "%.0f");
  const int most = static_cast<int>(std::clamp(frame.view.most_field_checks, 1.0, 100000.0));
  const std::optional<ReportPreview>& preview = frame.status.reporting;
  if (preview && preview->revision == frame.revision) {
    const std::string words = plural(std::min(most, preview->field_check_trees), "tree", "trees") + " of " + count_text(preview->field_check_trees) + " that are in doubt and undecided";
    w.paragraph(words, TextRole::table, Tone::secondary);
    w.record_last("check/preview", words);
  }
  const std::string suffix = std::filesystem::path(check_path_).extension().string();
  const bool needs_earth = suffix == ".gpx" && frame.state().georeference.kind == GeoreferenceKind::none;
  const std::string& no_doubt = frame.available[static_cast<std::size_t>(ActionId::export_field_check)].why_not;
  const std::string why_not = !no_doubt.empty() ? no_doubt : frame.view.most_field_checks < 1.0 ? "At least one tree" : needs_earth ? "Waypoints need a place on the earth: georeference the project in step 4 first" : "";
  w.action_button("check/look", ActionId::export_preview_field_check, frame.available, frame.requests, {.width = -1.0f});
  if (w.button("check/run", "Write the sheet", {.width = -1.0f, .why_not = why_not})) frame.requests.emit(request::WriteFieldCheck{check_path_, most});
}

}  // namespace stemwise::ui
