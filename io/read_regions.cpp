#include "io/read_regions.hpp"

#include <nlohmann/json.hpp>

#include "io/read_whole_file.hpp"

namespace stemwise {
namespace {

using Json = nlohmann::json;

std::optional<Polygon> polygon_from(const Json& corners) {
  if (!corners.is_array() || corners.size() < 3) return std::nullopt;
  Polygon polygon;
  for (const Json& corner : corners) {
    if (!corner.is_array() || corner.size() != 2 || !corner[0].is_number() || !corner[1].is_number()) return std::nullopt;
    polygon.corners_m.emplace_back(corner[0].get<double>(), corner[1].get<double>());
  }
  return polygon;
}

}  // namespace

Result<std::vector<Polygon>> read_regions(const std::string& path, const std::string& key) {
  using Regions = std::vector<Polygon>;
  const auto fail = [&](const std::string& text) {
    return Result<Regions>::failure({Severity::error, path, 0, key, text, "expected {\"" + key + "\": [[[x, y], ...], ...]}"});
  };
  const auto bytes = read_whole_file(path);
  if (!bytes) return fail("the file of regions cannot be read");
  const Json file = Json::parse(bytes->text(), nullptr, false);
  if (!file.is_object()) return fail("the file of regions is not a JSON object");
  if (!file.contains(key) || !file[key].is_array()) return fail("the file has no list of regions '" + key + "'");
  Regions regions;
  for (const Json& corners : file[key]) {
    auto polygon = polygon_from(corners);
    if (!polygon) return fail("region " + std::to_string(regions.size() + 1) + " is not a list of three or more [x, y]");
    regions.push_back(std::move(*polygon));
  }
  if (regions.empty()) return fail("the list of regions '" + key + "' is empty, so that no query would count");
  return regions;
}

}  // namespace stemwise
