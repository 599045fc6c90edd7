#include "app/check_output.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "io/project_file.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code code;
  return fs::equivalent(a, b, code) && !code;
}

std::string lower_suffix(const std::string& path) {
  std::string suffix = fs::path(path).extension().string();
  for (char& c : suffix) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return suffix;
}

/// What our own --json begins with, and no table, project or GeoJSON does.
bool may_hold_a_result(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(4096, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return true;
  return (head[first] == '{' || head[first] == '[') && head.find("\"Feature") == std::string::npos;
}

/// Does a word of the command line, beside the one after --json, name this file (`FILE`, `FILE:KEY`)?
bool is_named_elsewhere(const std::string& path, const std::vector<std::string>& words) {
  const auto plain = [](const std::string& name) { return fs::absolute(name).lexically_normal(); };
  for (std::size_t i = 0; i < words.size(); ++i) {
    if ((i > 0 && words[i - 1] == "--json") || words[i].empty() || words[i].starts_with("-")) continue;
    const std::string file = words[i].substr(0, words[i].rfind(':'));
    for (const std::string& name : {words[i], file})
      if (!name.empty() && (plain(name) == plain(path) || is_same_file(name, path))) return true;
  }
  return false;
}

}  // namespace

ExitCode check_json_target(const std::string& path, const std::vector<std::string>& words, Console& console) {
  std::error_code code;
  if (path.empty() || path == "-") return ExitCode::done;
  if (is_named_elsewhere(path, words)) {
    console.error("--json " + path + ": the same file is given to this command otherwise, and writing would destroy it; choose another name");
    return ExitCode::usage;
  }
  if (!fs::is_regular_file(path, code) || may_hold_a_result(path)) return ExitCode::done;
  console.error("--json " + path + ": the file is there and is no earlier result, and writing would destroy it; choose another name");
  return ExitCode::usage;
}

ExitCode check_table_target(const std::string& option, const std::string& path, const std::string& head, const std::vector<std::string>& inputs,
                            const CommonOptions& common, Console& console) {
  if (path.empty()) return ExitCode::done;
  if (path == "-") {
    if (common.json != "-") return ExitCode::done;
    console.error(option + " - and --json - both go to stdout: give one of them a file");
    return ExitCode::usage;
  }
  std::error_code code;
  const fs::path folder = fs::absolute(path).parent_path();
  if (!fs::is_directory(folder, code)) {
    console.error(path + ": cannot be written, there is no folder " + folder.string());
    return ExitCode::failed;
  }
  const bool among_inputs = std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) { return !input.empty() && (is_same_file(path, input) || is_same_file(folder.string(), input)); });
  std::ifstream file(path, std::ios::binary);
  std::string begin(head.size(), '\0');
  const bool is_table = !fs::is_regular_file(path, code) || (file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == head);
  if (!among_inputs && is_table) return ExitCode::done;
  console.error(option + " " + path + ": " + (among_inputs ? "this is where the input lies" : "the file is there and is no earlier table") +
                ", and writing could destroy it; choose another name");
  return ExitCode::usage;
}

ExitCode check_no_source(const std::string& output, const ProjectState& state, Console& console) {
  for (const auto& inventory : state.inventories) {
    if (inventory->source.path.empty() || !is_same_file(output, inventory->source.path)) continue;
    console.error("-o " + output + ": survey " + inventory->name + " was read from this file, and writing would destroy it; choose another name");
    return ExitCode::usage;
  }
  return ExitCode::done;
}

ExitCode check_decisions_kept(const std::string& project, Console& console) {
  if (!is_project(project)) return ExitCode::done;
  const Result<ProjectState> there = read_project(project);
  if (!there || there->edit_log.empty()) return ExitCode::done;
  console.error(project + ": this project holds " + std::to_string(there->edit_log.size()) +
                " edits made by hand, which a new run would not know; add surveys to it (stemwise align " + project + " NEW -o " + project + "), move it away, or choose another name");
  return ExitCode::usage;
}

ExitCode check_suffix(const std::string& output, const std::vector<std::string>& suffixes, const std::string& what, Console& console) {
  if (std::find(suffixes.begin(), suffixes.end(), lower_suffix(output)) != suffixes.end()) return ExitCode::done;
  std::string all;
  for (const std::string& suffix : suffixes)
    if (!suffix.empty()) all += (all.empty() ? "" : ", ") + suffix;
  console.error("-o " + output + ": the name's end says the format, and " + what + " is written as one of " + all);
  return ExitCode::usage;
}

ExitCode check_output(const std::string& output, OutputKind kind, const std::vector<std::string>& inputs, Console& console) {
  std::error_code code;
  if (output.empty()) {
    console.error("-o: expected the name of the file to write, not nothing");
    return ExitCode::usage;
  }
  const fs::path folder = fs::absolute(output).parent_path();
  if (!fs::is_directory(folder, code)) {
    console.error(output + ": cannot be written, there is no folder " + folder.string());
    return ExitCode::failed;
  }
  if (kind == OutputKind::project && lower_suffix(output) != ".gpkg") {
    console.error("-o " + output + ": a project is a GeoPackage; give it a name that ends in .gpkg");
    return ExitCode::usage;
  }
  const bool project = is_project(output);
  for (const std::string& input : inputs) {
    if (!is_same_file(output, input) || (kind == OutputKind::project && project)) continue;
    console.error("-o " + output + ": this is what is read, and writing would destroy it; choose another name");
    return ExitCode::usage;
  }
  if (kind == OutputKind::project && !project && fs::exists(output, code)) {
    console.error("-o " + output + ": a file that is no Stemwise project is there, and writing would destroy it; choose another name");
    return ExitCode::usage;
  }
  if (kind == OutputKind::other && project) {
    console.error("-o " + output + ": this is a Stemwise project, and writing would destroy it; choose another name");
    return ExitCode::usage;
  }
  return ExitCode::done;
}

}  // namespace stemwise
