#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/treeloc/localizer.hpp"
#include "core/treeloc/settings.hpp"
#include "io/descriptor_cache.hpp"

namespace stemwise {

/// A survey by frames, ready to be localised in or to be localised, and how it came.
struct ReadSurvey {
  std::string name;
  treeloc::DescribedScenes described{{}};
  bool scenes_from_cache = false;
  bool triangles_from_cache = false;
  double read_s = 0.0;      ///< files; from the cache: all of it
  double describe_s = 0.0;  ///< preparing scenes and making triangles
  double index_s = 0.0;     ///< of it: making triangles
  double keep_s = 0.0;      ///< writing the cache
};

/// Where descriptors are kept between runs, and what they depend on beside files and settings.
struct SurveyCacheOptions {
  std::string folder;  ///< empty: nothing is kept
  std::uint64_t most_bytes = DescriptorCache::usual_most_bytes;
  std::string program;                      ///< tells builds apart
  std::function<std::int64_t()> now_ns;     ///< since 1970; empty: the system's clock
};

/// Frame folders to described scenes, frames some at a time. With a cache: the same scenes, triangles and issues, bit for bit, as
/// without. A cache entry counts only for the same path, program and settings and the same state of every file (folder_stamp);
/// nothing is kept of files that changed while they were read or a moment before.
class SurveyReader {
 public:
  SurveyReader(SurveyCacheOptions options, int threads);
  /// `with_triangles`: what `index_scenes` makes too (the default method's database).
  Result<ReadSurvey> read(const std::string& folder, const treeloc::Settings& settings, bool with_triangles) const;

 private:
  struct Keys {
    std::string scenes, triangles;
  };
  std::optional<Keys> keys_of(const std::string& folder, treeloc::Settings settings) const;
  bool take_from_cache(const Keys& keys, bool with_triangles, ReadSurvey& survey, Issues& issues) const;
  Result<ReadSurvey> read_frames(const std::string& folder, const treeloc::Settings& settings) const;

  SurveyCacheOptions options_;
  std::optional<DescriptorCache> cache_;
  int threads_;
};

}  // namespace stemwise
