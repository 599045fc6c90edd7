#include "io/read_trajectory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <Eigen/Geometry>

#include "io/parse_decimal.hpp"
#include "io/read_whole_file.hpp"

namespace stemwise {
namespace {

constexpr std::array<const char*, 8> column_names{"timestamp", "x", "y", "z", "qx", "qy", "qz", "qw"};
constexpr const char* expected_line = "expected: timestamp x y z qx qy qz qw";

bool is_separator(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r'; }

std::vector<std::string_view> split_words(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t at = 0;
  while (at < line.size()) {
    while (at < line.size() && is_separator(line[at])) ++at;
    const std::size_t begin = at;
    while (at < line.size() && !is_separator(line[at])) ++at;
    if (at > begin) words.push_back(line.substr(begin, at - begin));
  }
  return words;
}

TrajectoryPose pose_from(const std::array<double, 8>& v) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(v[7], v[4], v[5], v[6]).normalized();
  return {v[0], {q.toRotationMatrix(), Eigen::Vector3d(v[1], v[2], v[3])}};
}

/// One line that is no comment; adds an issue and gives nothing when it is bad.
std::optional<TrajectoryPose> read_line(std::string_view line, Issue place, Issues& issues) {
  const auto words = split_words(line);
  if (words.size() < column_names.size()) {
    place.text = std::to_string(words.size()) + " values instead of 8: the line is left out";
    place.help = expected_line;
    issues.push_back(std::move(place));
    return std::nullopt;
  }
  std::array<double, 8> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto number = parse_decimal(words[i]);
    if (!number) {
      place.column = column_names[i];
      place.text = "'" + std::string(words[i]) + "' is not a finite number: the line is left out";
      place.help = expected_line;
      issues.push_back(std::move(place));
      return std::nullopt;
    }
    values[i] = *number;
  }
  const double norm = std::sqrt(values[4] * values[4] + values[5] * values[5] + values[6] * values[6] + values[7] * values[7]);
  if (std::abs(norm - 1.0) <= 0.05) return pose_from(values);
  place.column = "qx qy qz qw";
  place.text = "the quaternion's length is " + std::to_string(norm) + ", not 1: the line is left out";
  issues.push_back(std::move(place));
  return std::nullopt;
}

}  // namespace

Result<std::vector<std::optional<TrajectoryPose>>> read_trajectory(const std::string& path) {
  using Poses = std::vector<std::optional<TrajectoryPose>>;
  const auto bytes = read_whole_file(path);
  if (!bytes)
    return Result<Poses>::failure({Severity::error, path, 0, "", "the trajectory is missing or cannot be read", expected_line});
  Issues issues;
  Poses poses;
  std::string_view rest = bytes->text();
  for (std::int64_t row = 1; !rest.empty(); ++row) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || line[first] == '#') continue;
    poses.push_back(read_line(line, {Severity::warning, path, row, "", "", ""}, issues));
  }
  if (std::none_of(poses.begin(), poses.end(), [](const auto& p) { return p.has_value(); })) {
    issues.push_back({Severity::error, path, 0, "", "the trajectory has no usable line", expected_line});
    return Result<Poses>::failure(std::move(issues));
  }
  return {std::move(poses), std::move(issues)};
}

}  // namespace stemwise
