#include "app/window/preferences.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace stemwise {
namespace {

using Json = nlohmann::json;
constexpr std::size_t most_recent = 10;

template <class T>
void take(const Json& json, const char* key, T& value) {
  if (const auto it = json.find(key); it != json.end()) value = it->get<T>();
}

Preferences from_json(const Json& json) {
  Preferences p;
  take(json, "width", p.width);
  take(json, "height", p.height);
  take(json, "maximised", p.maximised);
  p.theme = json.value("theme", "light") == "dark" ? ui::ThemeName::dark : ui::ThemeName::light;
  take(json, "reduce_motion", p.reduce_motion);
  take(json, "goes_on", p.goes_on);
  take(json, "zoom_percent", p.zoom_percent);
  take(json, "panel_left", p.panels.left);
  take(json, "panel_right", p.panels.right);
  take(json, "panel_bottom", p.panels.bottom);
  take(json, "show_left", p.panels.show_left);
  take(json, "show_right", p.panels.show_right);
  take(json, "show_bottom", p.panels.show_bottom);
  take(json, "links", p.layers.links);
  take(json, "coverage", p.layers.coverage);
  take(json, "grid", p.layers.grid);
  take(json, "ground", p.layers.ground);
  take(json, "labels", p.layers.labels);
  take(json, "recent_projects", p.recent_projects);
  take(json, "working_folder", p.working_folder);
  p.width = std::clamp(p.width, 800, 10000);
  p.height = std::clamp(p.height, 600, 10000);
  p.zoom_percent = std::clamp(p.zoom_percent, 75.0, 200.0);
  return p;
}

Json to_json(const Preferences& p) {
  return {{"width", p.width}, {"height", p.height}, {"maximised", p.maximised},
          {"theme", p.theme == ui::ThemeName::dark ? "dark" : "light"}, {"reduce_motion", p.reduce_motion}, {"goes_on", p.goes_on}, {"zoom_percent", p.zoom_percent},
          {"panel_left", p.panels.left}, {"panel_right", p.panels.right}, {"panel_bottom", p.panels.bottom},
          {"show_left", p.panels.show_left}, {"show_right", p.panels.show_right}, {"show_bottom", p.panels.show_bottom},
          {"links", p.layers.links}, {"coverage", p.layers.coverage}, {"grid", p.layers.grid}, {"ground", p.layers.ground}, {"labels", p.layers.labels},
          {"recent_projects", p.recent_projects}, {"working_folder", p.working_folder}};
}

}  // namespace

void Preferences::remember_project(const std::string& path) {
  forget_project(path);
  recent_projects.insert(recent_projects.begin(), path);
  if (recent_projects.size() > most_recent) recent_projects.resize(most_recent);
}

void Preferences::forget_project(const std::string& path) { std::erase(recent_projects, path); }

Preferences read_preferences(const std::string& path) {
  std::ifstream file(path);
  if (!file) return {};
  try {
    return from_json(Json::parse(file));
  } catch (const Json::exception&) {
    return {};
  }
}

bool write_preferences(const std::string& path, const Preferences& preferences) {
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
  const std::string beside = path + ".new";
  {
    std::ofstream file(beside);
    file << to_json(preferences).dump(2) << "\n";
    if (!file.flush()) return false;
  }
  std::filesystem::rename(beside, path, error);
  return !error;
}

}  // namespace stemwise
