#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/flat_array.hpp"
#include "core/treeloc/near_origins.hpp"
#include "core/treeloc/triangles.hpp"

namespace stemwise::treeloc {

/// What the vote needs of a triangle of the database once its origin is near enough: 8 bytes.
struct Posting {
  std::uint32_t scene = 0;
  std::uint8_t yaw = 0;
  std::uint8_t dbh_cm[3] = {0, 0, 0};
};

/// The triangles of a run of scenes by key: what describing a survey gives, and what may be kept of it between runs. Plain
/// arrays, so that they are read from a file as they are. A key's triangles are in order of scene.
struct IndexSegment {
  std::uint32_t scene_count = 0;       ///< scenes have the numbers below it
  FlatArray<std::uint32_t> start;      ///< per key the place of its first triangle, and one more
  FlatArray<TriangleOrigin> origins;   ///< per triangle, and `near_origins_lanes` beyond
  FlatArray<Posting> postings;         ///< per triangle
};

/// Makes the triangles of the scenes. The result does not depend on `threads`.
IndexSegment index_scenes(std::span<const Scene> scenes, const TriangleSettings& settings, int threads);

/// Inverted index from triangle key to the triangles of all scenes that have it (method.md, section 12). Made of segments,
/// one per `add`, so that a survey can be added to an index. Origins lie apart from the rest of a posting: most postings are
/// turned down by their origin alone.
class TriangleIndex {
public:
  explicit TriangleIndex(const TriangleSettings& settings) : settings_(settings), key_count_(TriangleKeys(settings).count()) {}

  /// Describes the scenes and adds them; they get the numbers from `scene_count()` on.
  void add(std::span<const Scene> scenes, int threads) { add(index_scenes(scenes, settings_, threads)); }
  /// Adds what `index_scenes` made with the same settings. Throws std::invalid_argument for one of another number of keys.
  void add(IndexSegment segment);

  std::uint32_t scene_count() const { return scene_count_; }
  std::size_t segment_count() const { return segments_.size(); }
  std::size_t triangle_count() const;

  /// Places in a segment's arrays.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  Range range(std::size_t segment, std::uint32_t key) const {
    const std::uint32_t* start = segments_[segment].start.data() + key;
    return {start[0], start[1] - start[0]};
  }
  /// May be read up to `near_origins_lanes` places beyond the end of any range.
  const TriangleOrigin* origins(std::size_t segment) const { return segments_[segment].origins.data(); }
  const Posting* postings(std::size_t segment) const { return segments_[segment].postings.data(); }
  /// Ask for what `range` and then `origins` will read: first the one, some triangles later the other.
  void prefetch_range(std::size_t segment, std::uint32_t key) const { __builtin_prefetch(segments_[segment].start.data() + key); }
  void prefetch_origins(std::size_t segment, std::uint32_t key) const {
    const IndexSegment& s = segments_[segment];
    const TriangleOrigin* first = s.origins.data() + s.start[key];
    __builtin_prefetch(first);
    __builtin_prefetch(first + 16);  // a cache line
  }

private:
  TriangleSettings settings_;
  std::uint32_t key_count_;
  std::uint32_t scene_count_ = 0;
  std::vector<IndexSegment> segments_;
};

}  // namespace stemwise::treeloc
