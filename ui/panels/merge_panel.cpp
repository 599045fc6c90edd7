#include "ui/panels/merge_panel.hpp"

#include <imgui.h>

#include <array>

#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

struct Policy {
  FusionPolicy policy;
  const char* label;
  const char* help;
};
constexpr std::array<Policy, 4> policies{{
    {FusionPolicy::min_dbh, "Smallest DBH", "The smallest measured DBH: careful where LiDAR tends to measure too thick."},
    {FusionPolicy::newest, "Newest DBH", "The latest survey that measured the tree."},
    {FusionPolicy::best, "Most certain DBH", "The survey with the smallest estimated error."},
    {FusionPolicy::mean, "Weighted mean", "The mean of all surveys, weighted by their errors."},
}};

std::string effect_words(const PolicyEffect& effect) {
  if (effect.changed == 0) return "same values";
  return plural(effect.changed, "tree", "trees") + ", mean " + change_text(effect.mean_change_m) + " cm";
}

/// What a survey says of a tree: "24.5 cm", "Picea abies", "0.12 m away"; "" where it says nothing.
std::string value_words(const Frame& frame, const TreeRow& tree, const ObservationRow& seen, FusedAttribute attribute) {
  const Stem* stem = frame.state().find(seen.stem);
  switch (attribute) {
    case FusedAttribute::dbh: return seen.dbh_m ? dbh_text(seen.dbh_m) + " cm" : "";
    case FusedAttribute::species: return stem != nullptr ? stem->species : "";
    case FusedAttribute::position: return distance_text((seen.position_m - tree.position_m).head<2>().norm()) + " from the merged place";
  }
  return "";
}

std::string merged_words(const Frame& frame, const TreeRow& tree, FusedAttribute attribute) {
  if (attribute == FusedAttribute::dbh) return dbh_text(tree.dbh_m) + " cm" + (tree.dbh_source ? " of " + survey_label(frame.state(), tree.dbh_source) : "");
  if (attribute == FusedAttribute::species) return tree.species.empty() ? "no species" : tree.species;
  return "weighted mean";
}

}  // namespace

void MergePanel::draw(Widgets& w, Frame& frame) {
  w.text("Merge and georeference", TextRole::title);
  draw_fusion(w, frame);
  draw_tree(w, frame);
  placement_.draw(w, frame);
  w.gap(12);
  if (w.button("merge/next", "Go on to report and export", {.width = -1.0f, .key = "5"})) frame.requests.run(ActionId::step_report);
}

/// Every policy with what it would do, before it is chosen.
void MergePanel::draw_fusion(Widgets& w, Frame& frame) {
  w.section("A merged tree takes its DBH from");
  const bool known = frame.status.fusion && frame.status.fusion->revision == frame.revision;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (std::size_t i = 0; i < policies.size(); ++i) {
    const Policy& p = policies[i];
    const bool on = frame.state().fusion == p.policy;
    const Rect row = w.next_rect(w.available_width(), w.px(28));
    if (on) w.fill(row, w.tokens().accent_soft, w.px(6));
    const std::string effect = on ? "chosen" : known ? effect_words(frame.status.fusion->policies[i]) : "…";
    if (w.area(std::string("merge/policy/") + to_string(p.policy), row, effect) && !on) frame.requests.emit(request::SetFusion{p.policy});
    if (ImGui::IsItemHovered()) w.tooltip(std::string(p.help) + " At the right: how many trees would get another diameter, and by how much on average.");
    w.text_in({row.x + w.px(8), row.y, w.px(126), row.height}, p.label, on ? TextRole::strong : TextRole::body, on ? Tone::accent : Tone::text);
    w.text_in({row.x + w.px(134), row.y, row.width - w.px(142), row.height}, effect, TextRole::table, on ? Tone::accent : Tone::secondary, Align::right);
  }
  ImGui::PopStyleVar();
  w.gap(4);
  const auto trees = static_cast<std::int64_t>(frame.tables().trees.size()), conflicts = static_cast<std::int64_t>(frame.derived.conflicts.size());
  w.paragraph(plural(trees, "merged tree", "merged trees") + "; every value names the survey that it came from.", TextRole::table, Tone::secondary);
  if (conflicts > 0 && w.button("merge/conflicts", plural(conflicts, "conflict", "conflicts") + " between surveys", {.quiet = true, .tooltip = "Lists them below"})) {
    frame.view.tab = BottomTab::conflicts;
    frame.view.panels.show_bottom = true;
  }
}

/// Of the selected tree: each value from the survey that a person names, whatever the policy says.
void MergePanel::draw_tree(Widgets& w, Frame& frame) {
  const TreeRow* tree = frame.derived.tree(frame.view.selected_tree);
  w.gap(4);
  if (!w.fold("merge/tree", tree == nullptr ? "One tree by hand" : "By hand: " + tree_label(tree->tree), tree_open_)) return;
  if (tree == nullptr) {
    w.paragraph("Select a tree on the map or in a table to choose where its values come from.", TextRole::table, Tone::secondary);
    return;
  }
  if (frame.derived.sightings(tree->tree).size() < 2) {
    w.paragraph("This tree was seen in one survey only.", TextRole::table, Tone::secondary);
    return;
  }
  const auto choices = fusion_choices(frame.state());
  const auto found = choices.find(tree->tree);
  const FusionChoice choice = found == choices.end() ? FusionChoice{} : found->second;
  draw_source(w, frame, *tree, FusedAttribute::dbh, choice.dbh);
  draw_source(w, frame, *tree, FusedAttribute::position, choice.position);
  draw_source(w, frame, *tree, FusedAttribute::species, choice.species);
}

void MergePanel::draw_source(Widgets& w, Frame& frame, const TreeRow& tree, FusedAttribute attribute, std::optional<InventoryId> chosen) {
  static constexpr const char* names[] = {"DBH", "Position", "Species"};
  const std::string name = names[static_cast<std::size_t>(attribute)];
  std::vector<std::string> items{"By the policy" + (chosen ? std::string() : ": " + merged_words(frame, tree, attribute))};
  std::vector<InventoryId> sources;
  int current = 0;
  for (const ObservationRow* seen : frame.derived.sightings(tree.tree)) {
    const std::string value = value_words(frame, tree, *seen, attribute);
    if (value.empty()) continue;
    sources.push_back(seen->stem.inventory);
    items.push_back(survey_label(frame.state(), seen->stem.inventory) + ": " + value);
    if (chosen == seen->stem.inventory) current = static_cast<int>(sources.size());
  }
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in({row.x, row.y, w.px(66), row.height}, name, TextRole::body, Tone::secondary);
  ImGui::SetCursorScreenPos({row.x + w.px(70), row.y});
  if (!w.combo(std::string("merge/source/") + to_string(attribute), items, current, row.width - w.px(70))) return;
  frame.requests.emit(request::ChooseSource{tree.tree, attribute, current == 0 ? std::nullopt : std::optional(sources[static_cast<std::size_t>(current - 1)])});
}

}  // namespace stemwise::ui
