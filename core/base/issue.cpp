#include "core/base/issue.hpp"

#include <algorithm>

namespace stemwise {

std::string to_string(const Issue& issue) {
  std::string place = issue.file;
  const auto add = [&place](const std::string& part) {
    if (!place.empty()) place += ", ";
    place += part;
  };
  if (issue.row > 0) add("row " + std::to_string(issue.row));
  if (!issue.column.empty()) add("column " + issue.column);
  std::string line = place.empty() ? issue.text : place + ": " + issue.text;
  if (!issue.help.empty()) line += " (" + issue.help + ")";
  return line;
}

bool has_error(const Issues& issues) {
  return std::any_of(issues.begin(), issues.end(), [](const Issue& i) { return i.severity == Severity::error; });
}

}  // namespace stemwise
