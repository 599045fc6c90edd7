#include "app/read_inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "io/read_frame_folder.hpp"

namespace stemwise {
namespace fs = std::filesystem;

std::string inventory_name(const std::string& path) {
  const fs::path clean = fs::absolute(path).lexically_normal();
  const fs::path last = clean.has_filename() ? clean.filename() : clean.parent_path().filename();
  std::error_code code;
  return fs::is_directory(clean, code) ? last.string() : last.stem().string();
}

std::vector<std::string> inventory_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    const std::string base = inventory_name(path);
    std::string name = base;
    for (int n = 2; std::find(names.begin(), names.end(), name) != names.end(); ++n) name = base + "-" + std::to_string(n);
    names.push_back(name);
  }
  return names;
}

ReadInputs read_inputs(const std::vector<std::string>& paths, const ReadOptions&, Session& session) {
  ReadInputs read;
  const std::vector<std::string> names = inventory_names(paths);
  const Progress progress = session.progress();
  for (std::size_t i = 0; i < paths.size(); ++i) {
    progress.at(static_cast<double>(i) / static_cast<double>(paths.size()), "Reading " + names[i]);
    ReadInput input{paths[i], names[i], read_frame_folder(paths[i], session.common.threads)};
    if (input.inventory) input.inventory->name = names[i];
    read.inputs.push_back(std::move(input));
  }
  session.console.end_progress();
  return read;
}

}  // namespace stemwise
