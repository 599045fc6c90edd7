#include "io/read_inventory.hpp"

#include <filesystem>

#include "io/inventory_date.hpp"
#include "io/open_table.hpp"
#include "io/project_file.hpp"
#include "io/read_frame_folder.hpp"
#include "io/stems_from_table.hpp"

namespace stemwise {
namespace {

Result<Inventory> refused(const std::string& path, std::string text, std::string help) {
  return Result<Inventory>::failure(Issue{Severity::error, path, 0, {}, std::move(text), std::move(help)});
}

Result<Inventory> read_folder(const std::string& path, const ReadOptions& options) {
  if (!is_frame_folder(path)) {
    return refused(path, "is a folder without trajectory.txt and TreeManagerState_<n>.csv", "name a frame folder, or a file with a stem list");
  }
  auto result = read_frame_folder(path, options.threads);
  if (result && options.date) {
    result->date = options.date;
    result->source.notes.push_back("date: " + to_string(*options.date) + ", as told");
  }
  if (result && !result->date) result->date = date_from_name(path);
  return result;
}

/// One inventory of a project: the one that is asked for, or the only one.
Result<Inventory> read_from_project(const std::string& path, const ReadOptions& options) {
  const auto state = read_project(path);
  if (!state) return Result<Inventory>::failure(state.issues);
  std::string names;
  const Inventory* chosen = nullptr;
  for (const auto& inventory : state->inventories) {
    names += (names.empty() ? "" : ", ") + inventory->name;
    if (options.sheet == inventory->name || state->inventories.size() == 1) chosen = inventory.get();
  }
  if (chosen == nullptr) {
    return refused(path, "is a project with the inventories " + names, "open it as a project, or choose one with --sheet NAME");
  }
  Inventory inventory = *chosen;
  inventory.id = {};
  if (options.date) {
    inventory.date = options.date;
    for (Stem& stem : inventory.stems) stem.date.reset();
  }
  inventory.source.notes.push_back("from project " + path);
  return inventory;
}

}  // namespace

Result<Inventory> read_inventory(const std::string& path, const ReadOptions& options) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return refused(path, "there is no such file or folder", "check the name");
  if (std::filesystem::is_directory(path, error)) return read_folder(path, options);
  if (is_project(path)) return read_from_project(path, options);
  if (auto opened = open_table(path, options)) {
    if (!*opened) return Result<Inventory>::failure(opened->issues);
    return inventory_from_table(std::move(**opened), options);
  }
  return refused(path, "is neither text nor a format that is read here", "save the stem list as CSV, XLSX, GeoPackage or Shapefile");
}

}  // namespace stemwise
