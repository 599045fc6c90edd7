#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/treeloc/triangles.hpp"

namespace stemwise::treeloc {

/// A triangle of the database as the vote needs it: 12 bytes, one after the other.
struct Posting {
  std::uint32_t scene = 0;
  std::int16_t origin_x_cm = 0;
  std::int16_t origin_y_cm = 0;
  std::uint8_t yaw = 0;
  std::uint8_t dbh_cm[3] = {0, 0, 0};
};

/// Inverted index from triangle key to the triangles of all scenes that have it (method.md, section 12). A key's postings
/// are in order of scene. Made of segments, one per `add`, so that a survey can be added to an index.
class TriangleIndex {
public:
  explicit TriangleIndex(const TriangleSettings& settings) : settings_(settings), key_count_(TriangleKeys(settings).count()) {}

  /// Describes the scenes and adds them; they get the numbers from `scene_count()` on.
  void add(std::span<const Scene> scenes, int threads);

  std::uint32_t scene_count() const { return scene_count_; }
  std::size_t segment_count() const { return segments_.size(); }
  std::size_t triangle_count() const;
  /// Ask for what `postings` will read: first the one, some triangles later the other.
  void prefetch_start(std::size_t segment, std::uint32_t key) const { __builtin_prefetch(segments_[segment].start.data() + key); }
  void prefetch_postings(std::size_t segment, std::uint32_t key) const {
    __builtin_prefetch(segments_[segment].postings.data() + segments_[segment].start[key]);
  }
  std::span<const Posting> postings(std::size_t segment, std::uint32_t key) const {
    const Segment& s = segments_[segment];
    return {s.postings.data() + s.start[key], s.postings.data() + s.start[key + 1]};
  }

private:
  struct Segment {
    std::vector<std::uint32_t> start;  ///< per key, and one more
    std::vector<Posting> postings;
  };
  TriangleSettings settings_;
  std::uint32_t key_count_;
  std::uint32_t scene_count_ = 0;
  std::vector<Segment> segments_;
};

}  // namespace stemwise::treeloc
