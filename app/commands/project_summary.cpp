#include "app/commands/project_summary.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/survey/rule_pack.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {
namespace {

using nlohmann::ordered_json;

AlignmentStatus status_of(const ProjectState& state, InventoryId id) {
  if (id == state.reference) return AlignmentStatus::reference;
  const auto found = state.alignments.find(id);
  return found == state.alignments.end() ? AlignmentStatus::unaligned : found->second.status;
}

std::string inventory_line(const ProjectState& state, const Inventory& inventory) {
  char text[256];
  const AlignmentStatus status = status_of(state, inventory.id);
  std::snprintf(text, sizeof text, "%zu stems, %s, %s", inventory.stems.size(), inventory.date ? to_string(*inventory.date).c_str() : "no date", to_string(status));
  std::string line = inventory.name + ": " + text;
  const auto found = state.alignments.find(inventory.id);
  if (found == state.alignments.end() || status == AlignmentStatus::reference) return line;
  const InventoryAlignment& a = found->second;
  if (status == AlignmentStatus::aligned) {
    std::snprintf(text, sizeof text, " (%d matched, overlap %.2f, residual RMS %.1f cm)", a.matched, a.overlap, 100.0 * a.residual_rms_m);
    return line + text;
  }
  return a.reason.empty() ? line : line + " (" + a.reason + ")";
}

std::string place_line(const Georeference& g) {
  if (g.kind == GeoreferenceKind::none) return "none (local coordinates)";
  char text[120];
  std::snprintf(text, sizeof text, ", origin %.6f, %.6f", g.origin.latitude_deg, g.origin.longitude_deg);
  return g.method + (g.kind == GeoreferenceKind::anchor ? text : "") + (g.geoid.name.empty() ? "" : ", heights above " + g.geoid.name);
}

int by_hand(const ProjectState& state) {
  return static_cast<int>(std::count_if(state.matches.begin(), state.matches.end(), [](const auto& entry) { return entry.second.state != MatchState::automatic; }));
}

std::string line(const char* what, const std::string& text) {
  char start[32];
  std::snprintf(start, sizeof start, "  %-14s ", what);
  return start + text + "\n";
}

std::string fates_line(const Tables& tables) {
  std::string text;
  for (std::size_t i = 0; i < fate_count; ++i)
    if (tables.trees_by_fate[i] > 0) text += (text.empty() ? "" : ", ") + std::to_string(tables.trees_by_fate[i]) + " " + to_string(static_cast<Fate>(i));
  return text;
}

}  // namespace

std::string project_text(const std::string& path, const ProjectState& state) {
  const Tables tables = derive_tables(state);
  const auto rules = chosen_rules(state);
  std::string text = path + "\n" + line("format", "Stemwise project");
  if (!state.title.empty()) text += line("title", state.title);
  for (const auto& inventory : state.inventories) text += line("inventory", inventory_line(state, *inventory));
  text += line("trees", std::to_string(tables.trees.size()) + (tables.trees.empty() ? "" : " (" + fates_line(tables) + ")"));
  text += line("matches", std::to_string(state.matches.size()) + ", " + std::to_string(by_hand(state)) + " decided by hand");
  text += line("to review", std::to_string(std::count_if(tables.queue.begin(), tables.queue.end(), [](const QueueRow& q) { return !q.decided; })));
  text += line("fusion", to_string(state.fusion)) + line("georeference", place_line(state.georeference));
  return text + line("rules", rules ? rules->name : "none") + line("edits", std::to_string(state.edit_log.size()));
}

ordered_json project_json(const std::string& path, const ProjectState& state) {
  const Tables tables = derive_tables(state);
  ordered_json inventories = ordered_json::array();
  for (const auto& inventory : state.inventories) {
    ordered_json one{{"name", inventory->name}, {"stems", inventory->stems.size()}, {"status", to_string(status_of(state, inventory->id))}};
    one["date"] = inventory->date ? ordered_json(to_string(*inventory->date)) : ordered_json();
    if (const auto found = state.alignments.find(inventory->id); found != state.alignments.end()) {
      one["reason"] = found->second.reason.empty() ? ordered_json() : ordered_json(found->second.reason);
      one["matched"] = found->second.matched;
      one["residual_rms_m"] = found->second.residual_rms_m;
    }
    inventories.push_back(one);
  }
  ordered_json fates;
  for (std::size_t i = 0; i < fate_count; ++i)
    if (tables.trees_by_fate[i] > 0) fates[to_string(static_cast<Fate>(i))] = tables.trees_by_fate[i];
  const auto rules = chosen_rules(state);
  ordered_json json{{"path", path}, {"format", "Stemwise project"}, {"title", state.title}, {"inventories", inventories}};
  json["trees"] = {{"unique", tables.trees.size()}, {"by_fate", fates}};
  json["matches"] = {{"count", state.matches.size()}, {"decided_by_hand", by_hand(state)}};
  json["fusion"] = to_string(state.fusion);
  json["georeference"] = state.georeference.kind == GeoreferenceKind::none ? ordered_json() : ordered_json(state.georeference.method);
  json["rules"] = rules ? ordered_json(rules->name) : ordered_json();
  return json;
}

}  // namespace stemwise
