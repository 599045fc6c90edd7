#include "io/descriptor_cache.hpp"

#include <array>
#include <cstring>
#include <type_traits>

namespace stemwise {
namespace {

using treeloc::Scene;
using treeloc::SceneTree;

/// A tree and a scene as they lie in the file: no gaps, so that the same values are the same bytes.
struct TreeRecord {
  std::array<double, 7> numbers;  ///< position, axis, diameter
  std::int32_t clusters;
  std::uint32_t flags;
};
struct SceneRecord {
  std::int64_t number;
  std::array<double, 22> numbers;  ///< survey_from_scene, aligned_from_scene, ground
  std::uint32_t flags;
  std::uint32_t trees;
};
static_assert(std::has_unique_object_representations_v<std::array<std::uint32_t, 2>> && sizeof(TreeRecord) == 64 && sizeof(SceneRecord) == 192);

TreeRecord record_of(const SceneTree& t) {
  return {{t.position_m.x(), t.position_m.y(), t.position_m.z(), t.axis.x(), t.axis.y(), t.axis.z(), t.dbh_m},
          t.clusters,
          (t.has_height ? 1U : 0U) | (t.reconstructed ? 2U : 0U) | (t.own ? 4U : 0U)};
}

SceneTree tree_of(const TreeRecord& r) {
  SceneTree t;
  t.position_m = {r.numbers[0], r.numbers[1], r.numbers[2]};
  t.axis = {r.numbers[3], r.numbers[4], r.numbers[5]};
  t.dbh_m = r.numbers[6];
  t.clusters = r.clusters;
  t.has_height = (r.flags & 1U) != 0;
  t.reconstructed = (r.flags & 2U) != 0;
  t.own = (r.flags & 4U) != 0;
  return t;
}

SceneRecord record_of(const Scene& s) {
  SceneRecord r{};
  r.number = s.number;
  std::copy_n(s.survey_from_scene.rotation.data(), 9, r.numbers.begin());
  std::copy_n(s.survey_from_scene.translation_m.data(), 3, r.numbers.begin() + 9);
  std::copy_n(s.aligned_from_scene.data(), 9, r.numbers.begin() + 12);
  r.numbers[21] = s.ground_m;
  r.flags = (s.tilt_observed ? 1U : 0U) | (s.level_sensor ? 2U : 0U) | (s.ground_observed ? 4U : 0U);
  r.trees = static_cast<std::uint32_t>(s.trees.size());
  return r;
}

Scene scene_of(const SceneRecord& r) {
  Scene s;
  s.number = r.number;
  std::copy_n(r.numbers.begin(), 9, s.survey_from_scene.rotation.data());
  std::copy_n(r.numbers.begin() + 9, 3, s.survey_from_scene.translation_m.data());
  std::copy_n(r.numbers.begin() + 12, 9, s.aligned_from_scene.data());
  s.ground_m = r.numbers[21];
  s.tilt_observed = (r.flags & 1U) != 0;
  s.level_sensor = (r.flags & 2U) != 0;
  s.ground_observed = (r.flags & 4U) != 0;
  return s;
}

/// Texts one after the other, each behind its length.
void append(std::string& to, const std::string& text) { to += std::to_string(text.size()) + ":" + text; }
std::optional<std::string> take(std::string_view& from) {
  const std::size_t colon = from.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::size_t size = std::strtoull(std::string(from.substr(0, colon)).c_str(), nullptr, 10);
  from.remove_prefix(colon + 1);
  if (size > from.size()) return std::nullopt;
  std::string text(from.substr(0, size));
  from.remove_prefix(size);
  return text;
}

std::string text_of(const SurveyScenes& survey) {
  std::string text;
  append(text, survey.name);
  for (const Issue& i : survey.issues) {
    append(text, std::to_string(static_cast<int>(i.severity)));
    append(text, std::to_string(i.row));
    for (const std::string* part : {&i.file, &i.column, &i.text, &i.help}) append(text, *part);
  }
  return text;
}

/// Name and issues. False when the text is none of ours.
bool read_text(std::string_view text, SurveyScenes& survey) {
  auto name = take(text);
  if (!name) return false;
  survey.name = std::move(*name);
  while (!text.empty()) {
    std::array<std::string, 6> parts;
    for (std::string& part : parts) {
      auto taken = take(text);
      if (!taken) return false;
      part = std::move(*taken);
    }
    survey.issues.push_back({static_cast<Severity>(std::atoi(parts[0].c_str())), parts[2], std::atoll(parts[1].c_str()), parts[3], parts[4], parts[5]});
  }
  return true;
}

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

/// The next part as so many values; false when it is none.
template <class T>
bool read_values(CacheReader& reader, std::size_t part, FlatArray<T>& values) {
  if (reader.size_of(part) % sizeof(T) != 0) return false;
  values = FlatArray<T>(reader.size_of(part) / sizeof(T));
  return reader.read_next(std::as_writable_bytes(values.span()));
}

}  // namespace

std::optional<SurveyScenes> DescriptorCache::find_scenes(const std::string& key) const {
  auto reader = folder_.find("scenes", key);
  FlatArray<char> text;
  FlatArray<SceneRecord> scenes;
  FlatArray<TreeRecord> trees;
  if (!reader || reader->parts() != 3 || !read_values(*reader, 0, text) || !read_values(*reader, 1, scenes) ||
      !read_values(*reader, 2, trees) || !reader->is_whole())
    return std::nullopt;
  SurveyScenes survey;
  if (!read_text({text.data(), text.size()}, survey)) return std::nullopt;
  survey.scenes.reserve(scenes.size());
  std::size_t next = 0;
  for (const SceneRecord& record : scenes.span()) {
    Scene& scene = survey.scenes.emplace_back(scene_of(record));
    if (record.trees > trees.size() - next) return std::nullopt;
    scene.trees.reserve(record.trees);
    for (const TreeRecord& tree : trees.span().subspan(next, record.trees)) scene.trees.push_back(tree_of(tree));
    next += record.trees;
  }
  return survey;
}

bool DescriptorCache::keep_scenes(const std::string& key, const SurveyScenes& survey) const {
  const std::string text = text_of(survey);
  std::vector<SceneRecord> scenes;
  std::vector<TreeRecord> trees;
  for (const Scene& scene : survey.scenes) {
    scenes.push_back(record_of(scene));
    for (const SceneTree& tree : scene.trees) trees.push_back(record_of(tree));
  }
  const std::array parts{std::as_bytes(std::span(text.data(), text.size())), bytes_of(scenes), bytes_of(trees)};
  return folder_.keep("scenes", key, parts);
}

std::shared_ptr<treeloc::IndexSegment> DescriptorCache::find_triangles(const std::string& key) const {
  auto reader = folder_.find("triangles", key);
  auto index = std::make_shared<treeloc::IndexSegment>();
  FlatArray<std::uint32_t> count;
  if (!reader || reader->parts() != 4 || !read_values(*reader, 0, count) || count.size() != 1 || !read_values(*reader, 1, index->start) ||
      !read_values(*reader, 2, index->origins) || !read_values(*reader, 3, index->postings) || !reader->is_whole())
    return nullptr;
  const bool fits = index->start.size() > 0 && index->start[index->start.size() - 1] == index->postings.size() &&
                    index->origins.size() == index->postings.size() + treeloc::near_origins_lanes;
  if (!fits) return nullptr;
  index->scene_count = count[0];
  return index;
}

bool DescriptorCache::keep_triangles(const std::string& key, const treeloc::IndexSegment& triangles) const {
  const std::array parts{std::as_bytes(std::span(&triangles.scene_count, 1)), std::as_bytes(triangles.start.span()),
                         std::as_bytes(triangles.origins.span()), std::as_bytes(triangles.postings.span())};
  return folder_.keep("triangles", key, parts);
}

}  // namespace stemwise
