#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/issue.hpp"
#include "core/treeloc/scene.hpp"
#include "core/treeloc/triangle_index.hpp"
#include "io/cache_folder.hpp"

namespace stemwise {

/// What reading and preparing a survey's frames gave.
struct SurveyScenes {
  std::string name;  ///< of the inventory
  Issues issues;     ///< what reading had to say: said again when it comes from the cache
  std::vector<treeloc::Scene> scenes;
};

/// Scenes and triangles of surveys between runs. The key must hold everything that they depend on. What comes back equals, bit
/// for bit, what was kept.
class DescriptorCache {
 public:
  static constexpr std::uint64_t usual_most_bytes = std::uint64_t{1} << 30;
  DescriptorCache(std::string folder, std::uint64_t most_bytes) : folder_(std::move(folder), most_bytes) {}

  std::optional<SurveyScenes> find_scenes(const std::string& key) const;
  bool keep_scenes(const std::string& key, const SurveyScenes& survey) const;
  /// Null: not there.
  std::shared_ptr<treeloc::IndexSegment> find_triangles(const std::string& key) const;
  bool keep_triangles(const std::string& key, const treeloc::IndexSegment& triangles) const;

 private:
  CacheFolder folder_;
};

}  // namespace stemwise
