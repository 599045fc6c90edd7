#include "app/window/underlay_memory.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/replace_file.hpp"

namespace stemwise {
namespace {

using Json = nlohmann::json;
constexpr std::array<const char*, 3> shade_words{"colour", "intensity", "height"};

Json json_of(const ui::Underlay& u) {
  return {{"path", u.path}, {"cloud", u.is_cloud}, {"frame", u.frame.value}, {"visible", u.visible}, {"opacity", u.opacity},
          {"from_m", u.low_m}, {"to_m", u.high_m}, {"shade", shade_words[static_cast<std::size_t>(u.shade)]}};
}

ui::Underlay underlay_of(const Json& json) {
  ui::Underlay u;
  u.path = json.at("path").get<std::string>();
  u.is_cloud = json.at("cloud").get<bool>();
  u.frame = InventoryId{json.at("frame").get<std::int64_t>()};
  u.visible = json.value("visible", true);
  u.opacity = std::clamp(json.value("opacity", u.opacity), 0.05f, 1.0f);
  u.low_m = json.value("from_m", u.low_m);
  u.high_m = json.value("to_m", u.high_m);
  const auto word = std::find(shade_words.begin(), shade_words.end(), json.value("shade", "height"));
  if (word != shade_words.end()) u.shade = static_cast<ui::CloudShade>(word - shade_words.begin());
  u.is_remembered = true;
  return u;
}

}  // namespace

UnderlayMemory UnderlayMemory::read(const std::string& path) {
  UnderlayMemory memory;
  memory.path_ = path;
  std::ifstream file(path);
  if (!file) return memory;
  try {
    const Json all = Json::parse(file);
    for (const auto& [project, list] : all.items()) memory.entries_[project] = list.dump();
  } catch (const Json::exception&) {
    memory.entries_.clear();
  }
  return memory;
}

std::vector<ui::Underlay> UnderlayMemory::find(const std::string& project) const {
  std::vector<ui::Underlay> underlays;
  const auto found = entries_.find(project);
  if (found == entries_.end()) return underlays;
  try {
    for (const Json& json : Json::parse(found->second)) underlays.push_back(underlay_of(json));
  } catch (const Json::exception&) {
    underlays.clear();
  }
  return underlays;
}

void UnderlayMemory::remember(const std::string& project, const std::vector<ui::Underlay>& underlays) {
  Json list = Json::array();
  for (const ui::Underlay& u : underlays) list.push_back(json_of(u));
  const std::string text = list.dump(-1, ' ', false, Json::error_handler_t::replace);
  const auto found = entries_.find(project);
  if (underlays.empty() ? found == entries_.end() : found != entries_.end() && found->second == text) return;
  if (underlays.empty()) {
    entries_.erase(found);
  } else {
    entries_[project] = text;
  }
  write();
}

void UnderlayMemory::write() const {
  if (path_.empty()) return;
  Json all = Json::object();
  for (const auto& [project, text] : entries_) all[project] = Json::parse(text);
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(path_).parent_path(), error);
  write_text_file(path_, all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");  // kept as well as it can be: only a memory
}

}  // namespace stemwise
