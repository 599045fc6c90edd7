#include "app/commands/inventory_summary.hpp"

#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

namespace stemwise {
namespace {

using nlohmann::ordered_json;

void count(const Stem& stem, const Eigen::Vector3d& at_m, InventorySummary& sum) {
  ++sum.stems;
  sum.with_dbh += stem.dbh_m.has_value() ? 1 : 0;
  sum.with_z += stem.z_m.has_value() ? 1 : 0;
  sum.with_axis += stem.axis.has_value() ? 1 : 0;
  sum.with_species += stem.species.empty() ? 0 : 1;
  sum.dead += stem.status == StemStatus::dead ? 1 : 0;
  sum.removed += stem.status == StemStatus::removed ? 1 : 0;
  sum.low_m = sum.low_m.cwiseMin(at_m.head<2>());
  sum.high_m = sum.high_m.cwiseMax(at_m.head<2>());
}

std::string share(std::size_t part, std::size_t whole) {
  char text[48];
  std::snprintf(text, sizeof text, "%zu (%.0f %%)", part, whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole));
  return text;
}

std::string line(const char* what, const std::string& text) {
  char start[32];
  std::snprintf(start, sizeof start, "  %-10s ", what);
  return start + text + "\n";
}

const char* severity_word(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

ordered_json problem_json(const Issue& issue) {
  return {{"severity", severity_word(issue.severity)},
          {"file", issue.file},
          {"row", issue.row > 0 ? ordered_json(issue.row) : ordered_json()},
          {"column", issue.column.empty() ? ordered_json() : ordered_json(issue.column)},
          {"text", issue.text},
          {"help", issue.help}};
}

ordered_json recognised_json(const Inventory& inventory) {
  const InventorySummary sum = summarize(inventory);
  ordered_json json{{"format", inventory.source.format}, {"recognised", inventory.source.notes}};
  json["date"] = inventory.date ? ordered_json(to_string(*inventory.date)) : ordered_json();
  json["epsg"] = inventory.source.epsg ? ordered_json(*inventory.source.epsg) : ordered_json();
  json["frames"] = sum.frames;
  json["stems"] = sum.stems;
  json["with_dbh"] = sum.with_dbh;
  json["with_z"] = sum.with_z;
  json["with_axis"] = sum.with_axis;
  json["with_species"] = sum.with_species;
  json["dead"] = sum.dead;
  json["removed"] = sum.removed;
  json["extent_m"] = {{"x", {sum.low_m.x(), sum.high_m.x()}}, {"y", {sum.low_m.y(), sum.high_m.y()}}};
  return json;
}

}  // namespace

InventorySummary summarize(const Inventory& inventory) {
  InventorySummary sum;
  constexpr double far = std::numeric_limits<double>::infinity();
  sum.low_m.setConstant(far);
  sum.high_m.setConstant(-far);
  for (const Stem& stem : inventory.stems) count(stem, {stem.x_m, stem.y_m, stem.z_m.value_or(0.0)}, sum);
  if (inventory.frames) {
    sum.frames = inventory.frames->frames.size();
    if (inventory.stems.empty()) {
      for (const Frame& frame : inventory.frames->frames) {
        for (const Stem& stem : frame.stems) {
          count(stem, frame.pose.survey_from_frame * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0)), sum);
        }
      }
    }
  }
  if (sum.stems == 0) sum.low_m = sum.high_m = Eigen::Vector2d::Zero();
  return sum;
}

std::string info_text(const ReadInput& input) {
  std::string text = input.path + "\n";
  if (!input.inventory) return text + line("format", "not readable");
  const Inventory& inventory = *input.inventory;
  const InventorySummary sum = summarize(inventory);
  text += line("name", inventory.name) + line("format", inventory.source.format);
  for (const std::string& note : inventory.source.notes) text += line("recognised", note);
  if (sum.frames > 0) text += line("frames", std::to_string(sum.frames));
  text += line("stems", std::to_string(sum.stems) + (sum.frames > 0 && inventory.stems.empty() ? " sightings over all frames" : ""));
  text += line("with DBH", share(sum.with_dbh, sum.stems)) + line("with z", share(sum.with_z, sum.stems));
  text += line("with axis", share(sum.with_axis, sum.stems));
  if (sum.dead > 0) text += line("dead", share(sum.dead, sum.stems));
  if (sum.removed > 0) text += line("removed", share(sum.removed, sum.stems));
  text += line("date", inventory.date ? to_string(*inventory.date) : "unknown (give it with --date)");
  char extent[160];
  std::snprintf(extent, sizeof extent, "%.1f x %.1f m, x %.3f to %.3f, y %.3f to %.3f", sum.high_m.x() - sum.low_m.x(),
                sum.high_m.y() - sum.low_m.y(), sum.low_m.x(), sum.high_m.x(), sum.low_m.y(), sum.high_m.y());
  text += line("extent", extent);
  text += line("CRS", inventory.source.epsg ? "EPSG:" + std::to_string(*inventory.source.epsg) : "none (local coordinates)");
  return text + line("problems", std::to_string(input.inventory.issues.size()));
}

std::string info_json(const std::vector<ReadInput>& inputs, const ordered_json& projects) {
  ordered_json all = ordered_json::array();
  for (const ReadInput& input : inputs) {
    ordered_json one{{"path", input.path}, {"name", input.name}, {"usable", static_cast<bool>(input.inventory)}};
    if (input.inventory) one.update(recognised_json(*input.inventory));
    one["problems"] = ordered_json::array();
    for (const Issue& issue : input.inventory.issues) one["problems"].push_back(problem_json(issue));
    all.push_back(one);
  }
  ordered_json json{{"inventories", all}};
  if (!projects.empty()) json["projects"] = projects;
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace stemwise
