#include "io/read_manifest.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "io/delimited_text.hpp"
#include "io/text_file.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
using Plots = std::vector<ManifestPlot>;

char likely_delimiter(const std::string& text) {
  const std::string head = text.substr(0, text.find('\n'));
  return std::count(head.begin(), head.end(), ';') > std::count(head.begin(), head.end(), ',') ? ';' : ',';
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool says_yes(const std::string& text) {
  const std::string word = lower(text);
  return word == "1" || word == "true" || word == "yes" || word == "x" || word == "reference";
}

/// A plot's name becomes the name of its result folder.
bool can_be_folder(const std::string& plot) { return plot != "." && plot != ".." && plot.find('/') == std::string::npos; }

}  // namespace

Result<Plots> read_manifest(const std::string& path) {
  const Result<TextFile> file = read_text_file(path);
  if (!file) return Result<Plots>::failure(file.issues);
  const Grid grid = parse_delimited(file->text, likely_delimiter(file->text));
  std::map<std::string, std::size_t> columns;
  for (std::size_t c = 0; !grid.rows.empty() && c < grid.rows.front().cells.size(); ++c) columns[lower(grid.rows.front().cells[c])] = c;
  if (!columns.contains("plot") || !columns.contains("path")) {
    return Result<Plots>::failure(Issue{Severity::error, path, 1, "", "the header lacks columns", "expected plot,path and optionally name,date,reference"});
  }
  Plots plots;
  Issues issues;
  for (std::size_t i = 1; i < grid.rows.size(); ++i) {
    const GridRow& row = grid.rows[i];
    const auto cell = [&](const char* name) {
      const auto found = columns.find(name);
      return found == columns.end() || found->second >= row.cells.size() ? std::string() : row.cells[found->second];
    };
    const std::string plot = cell("plot"), file_path = cell("path");
    if (plot.empty() || file_path.empty() || !can_be_folder(plot)) {
      issues.push_back({Severity::warning, path, row.row, file_path.empty() ? "path" : "plot", "is empty or no name of a folder, the row is left out", ""});
      continue;
    }
    auto found = std::find_if(plots.begin(), plots.end(), [&](const ManifestPlot& p) { return p.plot == plot; });
    if (found == plots.end()) found = plots.insert(plots.end(), ManifestPlot{plot, {}});
    const fs::path absolute = fs::absolute(path).parent_path() / file_path;
    found->rows.push_back({row.row, absolute.lexically_normal().string(), cell("name"), cell("date"), says_yes(cell("reference"))});
  }
  if (!plots.empty()) return {plots, issues};
  issues.push_back({Severity::error, path, 0, "", "has no usable row", ""});
  return Result<Plots>::failure(issues);
}

}  // namespace stemwise
