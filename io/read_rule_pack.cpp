#include "io/read_rule_pack.hpp"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace stemwise {
namespace {

using nlohmann::json;

constexpr const char* help = R"(expected {"name": "mine", "rules": [{"flag": "too_fast", "growth_above_cm_per_year": 3}]}; see docs/rules.md)";

std::string value_text(const json& value) {
  if (!value.is_array()) return value.is_string() ? value.get<std::string>() : value.dump();
  std::string text;
  for (const json& one : value) text += (text.empty() ? "" : ",") + (one.is_string() ? one.get<std::string>() : one.dump());
  return text;
}

Result<Rule> rule_from(const json& object) {
  std::string text;
  for (const auto& [key, value] : object.items()) {
    std::string cell = value_text(value);
    for (char& c : cell)
      if (c == ';' || c == '\n') c = ' ';
    text += (text.empty() ? "" : ";") + key + "=" + cell;
  }
  return rule_from_text(text);
}

Result<RulePack> refused(const std::string& path, const std::string& text) {
  return Result<RulePack>::failure(Issue{Severity::error, path, 0, "", text, help});
}

}  // namespace

Result<RulePack> read_rule_pack(const std::string& path) {
  std::ifstream in(path);
  if (!in) return refused(path, "cannot be read");
  const json root = json::parse(in, nullptr, false);
  if (!root.is_object() || !root.contains("rules") || !root["rules"].is_array() || root["rules"].empty()) return refused(path, "is no JSON object with a list of rules");
  RulePack pack{std::filesystem::path(path).stem().string(), "own rules", {}};
  if (root.contains("name") && root["name"].is_string()) pack.name = root["name"];
  if (find_rule_pack(pack.name) != nullptr) return refused(path, "the name " + pack.name + " is taken by a built-in pack");
  Issues issues;
  for (std::size_t i = 0; i < root["rules"].size(); ++i) {
    const json& object = root["rules"][i];
    const auto rule = object.is_object() ? rule_from(object) : Result<Rule>::failure(Issue{Severity::error, "", 0, "", "is no object", help});
    if (rule) pack.rules.push_back(*rule);
    else issues.push_back({Severity::error, path, 0, "", "rule " + std::to_string(i + 1) + ": " + rule.issues.front().text, help});
  }
  if (!issues.empty()) return Result<RulePack>::failure(issues);
  return pack;
}

}  // namespace stemwise
