#include "ui/panels/rules_form.hpp"

#include <imgui.h>

#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

std::string chosen_name(const ProjectState& state) {
  const std::optional<RulePack> chosen = chosen_rules(state);
  return chosen ? chosen->name : "";
}

std::string count_words(const RulePreview& preview) {
  int broken = 0;
  for (const RuleCount& count : preview.counts) broken += count.broken;
  return broken == 0 ? "flags nothing" : "flags " + plural(broken, "pair", "pairs");
}

constexpr const char* own_rules_hint =
    "A JSON file: {\"name\": \"mine\", \"rules\": [{\"flag\": \"too_fast\", \"growth_above_cm_per_year\": 3, \"species\": [\"Picea\"]}]}. Other limits: change_below_cm, ratio_below, ratio_above, "
    "shrinkage_percent_per_year, least_dbh_cm. It then stands in this list: click it to use it.";

}  // namespace

void RulesForm::draw(Widgets& w, Frame& frame) {
  w.paragraph("Growth that nobody believes is flagged by published rules; nothing is ever deleted. Flags stand in the inspector, in exports and in the report.", TextRole::caption, Tone::secondary);
  const std::optional<RulePreviews>& rules = frame.status.rules;
  const bool known = rules && rules->revision == frame.revision;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  draw_pack(w, frame, nullptr, "", "No rules");
  for (const RulePack& pack : rule_packs()) {
    const RulePreview* found = nullptr;
    for (std::size_t i = 0; known && i < rules->packs.size(); ++i) {
      if (rules->packs[i].pack.name == pack.name) found = &rules->packs[i];
    }
    draw_pack(w, frame, found, pack.name, pack.title);
  }
  for (std::size_t i = rule_packs().size(); known && i < rules->packs.size(); ++i) draw_pack(w, frame, &rules->packs[i], rules->packs[i].pack.name, rules->packs[i].pack.name + ": own rules");
  ImGui::PopStyleVar();
  w.gap(4);
  if (w.button("rules/own", "Own rules from a file…", {.quiet = true, .tooltip = own_rules_hint})) frame.view.dialog = Dialog::rules_file;
}

void RulesForm::draw_pack(Widgets& w, Frame& frame, const RulePreview* preview, const std::string& name, const std::string& title) {
  const bool on = chosen_name(frame.state()) == name;
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  if (on) w.fill(row, w.tokens().accent_soft, w.px(6));
  const std::string count = preview != nullptr ? count_words(*preview) : name.empty() ? "" : "…";
  if (w.area("rules/" + (name.empty() ? "none" : name), row, count) && !on) {
    frame.requests.emit(request::ChooseRules{name.empty() ? std::nullopt : preview != nullptr ? std::optional(preview->pack) : std::optional(*find_rule_pack(name))});
  }
  const float count_width = w.text_width(count, TextRole::table) + w.px(2);
  w.text_in({row.x + w.px(8), row.y, row.width - count_width - w.px(28), row.height}, title, on ? TextRole::strong : TextRole::body, on ? Tone::accent : Tone::text);
  w.text_in({row.x, row.y, row.width - w.px(8), row.height}, count, TextRole::table, on ? Tone::accent : Tone::secondary, Align::right);
  if (on && preview != nullptr) draw_counts(w, *preview);
}

void RulesForm::draw_counts(Widgets& w, const RulePreview& preview) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (const RuleCount& count : preview.counts) {
    w.fact("rules/count/" + count.flag, "   " + flag_words(count.flag), count_text(count.broken) + " of " + count_text(count.judged), count.meaning);
  }
  ImGui::PopStyleVar();
}

}  // namespace stemwise::ui
