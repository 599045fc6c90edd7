#include "app/align_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/survey/stand_change.hpp"
#include "core/survey/stand_growth.hpp"

namespace stemwise {
namespace {

using nlohmann::ordered_json;

constexpr std::array dof_words{"x", "y", "yaw", "z", "roll", "pitch"};

std::string name_of(const ProjectState& state, InventoryId id) {
  const Inventory* inventory = state.find(id);
  return inventory == nullptr ? "" : inventory->name;
}

ordered_json matrix_json(const RigidTransform& transform) {
  const Eigen::Matrix4d m = transform.matrix();
  ordered_json rows = ordered_json::array();
  for (int r = 0; r < 4; ++r) rows.push_back({m(r, 0), m(r, 1), m(r, 2), m(r, 3)});
  return rows;
}

ordered_json observed_json(const ObservedDofs& observed) {
  ordered_json words = ordered_json::array();
  for (std::size_t i = 0; i < dof_words.size(); ++i) {
    if (observed.seen[i]) words.push_back(dof_words[i]);
  }
  return words;
}

ordered_json acceptance_json(const Acceptance& a) {
  return {{"log_likelihood_ratio", a.log_likelihood_ratio}, {"log_poses_tried", a.log_poses_tried}, {"margin", a.margin},
          {"second_best", a.second_best}, {"mirror", a.mirror}, {"probability", a.probability}};
}

ordered_json inventory_json(const Inventory& inventory, const InventoryAlignment& alignment) {
  const bool reference = alignment.status == AlignmentStatus::reference;
  const bool has_pose = reference || alignment.status == AlignmentStatus::aligned || alignment.status == AlignmentStatus::probable;
  ordered_json json{{"name", inventory.name}};
  json["date"] = inventory.date ? ordered_json(to_string(*inventory.date)) : ordered_json();
  json["trees"] = inventory.stems.size();
  json["status"] = to_string(alignment.status);
  json["reason"] = alignment.reason.empty() ? ordered_json() : ordered_json(alignment.reason);
  json["T_reference_from_inventory"] = has_pose ? matrix_json(alignment.reference_from_inventory) : ordered_json();
  json["observed"] = observed_json(alignment.observed);
  json["overlap"] = alignment.overlap;
  json["position_noise_m"] = alignment.position_noise_m;
  json["acceptance"] = reference ? ordered_json() : acceptance_json(alignment.acceptance);
  json["matched"] = alignment.matched;
  json["residual_rms_m"] = alignment.residual_rms_m;
  return json;
}

ordered_json trees_json(const Tables& tables) {
  ordered_json fates = ordered_json::object();
  for (std::size_t i = 0; i < fate_count; ++i) fates[to_string(static_cast<Fate>(i))] = tables.trees_by_fate[i];
  return {{"unique", tables.trees.size()}, {"by_fate", fates}};
}

double cm(double m) { return m * 100.0; }

/// Figures of changes, or null where no stem was measured twice: 0 would be a figure.
ordered_json of_changes(int n, ordered_json figure) { return n > 0 ? std::move(figure) : ordered_json(); }

ordered_json growth_json(const ProjectState& state, const GrowthRow& row) {
  return {{"from", name_of(state, row.from)},
          {"to", name_of(state, row.to)},
          {"years", row.years ? ordered_json(*row.years) : ordered_json()},
          {"n", row.n},
          {"median_dbh_change_cm", of_changes(row.n, cm(row.median_change_m))},
          {"ci95_cm", of_changes(row.n, {cm(row.ci95_m[0]), cm(row.ci95_m[1])})},
          {"p20_p80_cm", of_changes(row.n, {cm(row.p20_p80_m[0]), cm(row.p20_p80_m[1])})},
          {"dbh_error_cm", of_changes(row.n, cm(row.dbh_error_m))}};
}

ordered_json interval_json(const Estimate& estimate) { return {{"value", cm(estimate.value)}, {"ci95", {cm(estimate.ci95[0]), cm(estimate.ci95[1])}}}; }

/// What the contract's row does not have: the mean, which measurement error does not move, and what one tree can show.
void add_stand_growth(const StandGrowth& row, ordered_json& json) {
  json["mean_dbh_change_cm"] = of_changes(row.n, interval_json(row.mean_m));
  json["mean_dbh_change_cm_per_year"] = of_changes(row.years ? row.n : 0, interval_json(row.mean_m_per_year));
  json["robust_dbh_change_cm"] = of_changes(row.n, interval_json(row.robust_m));
  json["detection_limit_cm"] = of_changes(row.n, cm(row.detection_limit_m));
}

ordered_json components_json(const ComponentTable& table, bool all) {
  ordered_json json = ordered_json::object();
  for (std::size_t i = 0; i < component_count; ++i) {
    const ComponentSum& sum = table[i];
    if (all || sum.stems > 0) json[to_string(static_cast<Component>(i))] = {{"stems", sum.stems}, {"earlier_m2", sum.earlier_sq_m}, {"later_m2", sum.later_sq_m}};
  }
  return json;
}

ordered_json change_json(const ProjectState& state, const StandChange& change) {
  ordered_json json{{"from", name_of(state, change.from)}, {"to", name_of(state, change.to)}, {"without_dbh", change.without_dbh}};
  json["shared_area_ha"] = change.area_ha ? ordered_json(*change.area_ha) : ordered_json();
  json["components"] = components_json(change.all, true);
  json["classes"] = ordered_json::array();
  for (const ClassChange& row : change.by_class)
    json["classes"].push_back({{"low_cm", row.low_cm}, {"high_cm", row.high_cm}, {"components", components_json(row.table, false)}});
  return json;
}

ordered_json rejected_json(const ProjectState& state, std::span<const RejectedConstraint> rejected) {
  ordered_json list = ordered_json::array();
  const auto frame = [](const std::optional<std::size_t>& index) { return index ? ordered_json(*index) : ordered_json(); };
  for (const RejectedConstraint& c : rejected)
    list.push_back({{"a", name_of(state, c.a)}, {"frame_a", frame(c.frame_a)}, {"b", name_of(state, c.b)}, {"frame_b", frame(c.frame_b)}, {"residual_m", c.residual_m}});
  return list;
}

/// Inventories that hang together, the reference's group first; whatever nothing connects is a group of its own.
ordered_json groups_json(const ProjectState& state) {
  ordered_json together = ordered_json::array(), groups = ordered_json::array();
  for (const auto& inventory : state.inventories)
    if (state.is_placed(inventory->id)) together.push_back(inventory->name);
  if (!together.empty()) groups.push_back(together);
  for (const auto& inventory : state.inventories)
    if (!state.is_placed(inventory->id)) groups.push_back({inventory->name});
  return groups;
}

ordered_json timing_json(const AlignTiming& t) {
  return {{"read", t.read_s}, {"describe", t.describe_s}, {"retrieve", t.retrieve_s}, {"verify", t.verify_s},
          {"optimise", t.optimise_s}, {"match", t.match_s}, {"total", t.total_s}};
}

std::string survey_line(const Inventory& inventory, const InventoryAlignment& a) {
  char text[256];
  if (a.status == AlignmentStatus::reference) {
    std::snprintf(text, sizeof text, "%s: reference, %zu trees", inventory.name.c_str(), inventory.stems.size());
    return text;
  }
  std::snprintf(text, sizeof text, "%s: %s, %d of %zu trees matched, residual %.1f cm, overlap %.2f, margin %.0f", inventory.name.c_str(),
                to_string(a.status), a.matched, inventory.stems.size(), a.residual_rms_m * 100.0, a.overlap, a.acceptance.margin);
  return text + (a.reason.empty() ? std::string() : ": " + a.reason);
}

}  // namespace

std::string align_json(const ProjectState& state, const Tables& tables, std::span<const RejectedConstraint> rejected, const AlignTiming& timing, std::uint64_t seed) {
  ordered_json json{{"reference", name_of(state, state.reference)}, {"seed", seed}};
  json["inventories"] = ordered_json::array();
  for (const auto& inventory : state.inventories) {
    const auto found = state.alignments.find(inventory->id);
    json["inventories"].push_back(inventory_json(*inventory, found == state.alignments.end() ? InventoryAlignment{} : found->second));
  }
  json["pairs"] = ordered_json::array();
  for (const PairReport& pair : state.pairs) {
    json["pairs"].push_back({{"a", name_of(state, pair.a)}, {"b", name_of(state, pair.b)}, {"constraints", pair.constraints}, {"accepted", pair.accepted}});
  }
  json["rejected_constraints"] = rejected_json(state, rejected);
  json["groups"] = groups_json(state);
  json["trees"] = trees_json(tables);
  json["growth"] = ordered_json::array();
  for (const GrowthRow& row : tables.growth) json["growth"].push_back(growth_json(state, row));
  const std::vector<StandGrowth> growth = stand_growth(state, tables, {.seed = seed});
  for (std::size_t i = 0; i < std::min(growth.size(), tables.growth.size()); ++i) add_stand_growth(growth[i], json["growth"][i]);
  json["change"] = ordered_json::array();
  for (const StandChange& change : stand_changes(state, tables)) json["change"].push_back(change_json(state, change));
  json["timing_s"] = timing_json(timing);
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string align_text(const ProjectState& state, const Tables& tables) {
  std::string text;
  for (const auto& inventory : state.inventories) {
    const auto found = state.alignments.find(inventory->id);
    if (found != state.alignments.end()) text += survey_line(*inventory, found->second) + "\n";
  }
  text += std::to_string(tables.trees.size()) + " trees";
  for (std::size_t i = 0; i < fate_count; ++i) {
    if (tables.trees_by_fate[i] == 0) continue;
    std::string fate = to_string(static_cast<Fate>(i));
    std::replace(fate.begin(), fate.end(), '_', ' ');
    text += ", " + std::to_string(tables.trees_by_fate[i]) + " " + fate;
  }
  return text;
}

}  // namespace stemwise
