#include "app/check_output.hpp"

#include <filesystem>

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

}  // namespace

ExitCode check_output(const std::string& output, OutputKind kind, const std::vector<std::string>& inputs, Console& console) {
  std::error_code code;
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
  if (kind == OutputKind::other && project) {
    console.error("-o " + output + ": this is a Stemwise project, and writing would destroy it; choose another name");
    return ExitCode::usage;
  }
  return ExitCode::done;
}

}  // namespace stemwise
