#include "core/treeloc/triangle_index.hpp"

#include <algorithm>
#include <array>

#include "core/base/parallel.hpp"

namespace stemwise::treeloc {
namespace {

constexpr std::size_t scenes_per_block = 64;
constexpr std::uint32_t parts = 256;  // of the keys: what one of them fills stays in a core's cache

struct Entry {
  std::uint32_t key;
  TriangleOrigin origin;
  Posting posting;
};

/// The triangles of a run of scenes, part by part; within a part in order of scene.
struct Block {
  std::vector<Entry> entries;
  std::array<std::uint32_t, parts + 1> start{};
};

std::uint32_t keys_per_part(std::uint32_t key_count) { return key_count / parts + 1; }

Block sort_by_part(const std::vector<Entry>& made, std::uint32_t per_part) {
  Block block;
  for (const Entry& e : made) ++block.start[e.key / per_part + 1];
  for (std::size_t p = 0; p < parts; ++p) block.start[p + 1] += block.start[p];
  block.entries.resize(made.size());
  auto next = block.start;
  for (const Entry& e : made) block.entries[next[e.key / per_part]++] = e;
  return block;
}

std::vector<Block> describe_blocks(std::span<const Scene> scenes, std::uint32_t first_number, const TriangleSettings& settings,
                                   std::uint32_t per_part, int threads) {
  std::vector<Block> blocks((scenes.size() + scenes_per_block - 1) / scenes_per_block);
  parallel_for(blocks.size(), threads, [&](std::size_t b) {
    TriangleMaker maker(settings);
    std::vector<Entry> made;
    const std::size_t first = b * scenes_per_block;
    const std::size_t last = std::min(first + scenes_per_block, scenes.size());
    for (std::size_t s = first; s < last; ++s) {
      const auto scene = first_number + static_cast<std::uint32_t>(s);
      for (const Triangle& t : maker.make(scenes[s]))
        made.push_back({t.key, t.origin, {scene, t.yaw, {t.dbh_cm[0], t.dbh_cm[1], t.dbh_cm[2]}}});
    }
    blocks[b] = sort_by_part(made, per_part);
  });
  return blocks;
}

/// Fills one part of the keys; `place` is where its postings begin.
template <class Segment>
void fill_part(Segment& segment, std::span<const std::span<const Entry>> runs, std::uint32_t first_key, std::uint32_t end_key,
               std::uint32_t place) {
  std::vector<std::uint32_t> next(end_key - first_key, 0);
  for (const auto& run : runs) {
    for (const Entry& e : run) ++next[e.key - first_key];
  }
  for (std::uint32_t key = first_key; key < end_key; ++key) {
    const std::uint32_t count = next[key - first_key];
    segment.start[key] = next[key - first_key] = place;
    place += count;
  }
  for (const auto& run : runs) {
    for (const Entry& e : run) {
      const std::uint32_t at = next[e.key - first_key]++;
      segment.origins[at] = e.origin;
      segment.postings[at] = e.posting;
    }
  }
}

}  // namespace

void TriangleIndex::add(std::span<const Scene> scenes, int threads) {
  const std::uint32_t per_part = keys_per_part(key_count_);
  const auto blocks = describe_blocks(scenes, scene_count_, settings_, per_part, threads);
  std::array<std::uint32_t, parts + 1> place{};
  for (std::size_t p = 0; p < parts; ++p) {
    place[p + 1] = place[p];
    for (const Block& block : blocks) place[p + 1] += block.start[p + 1] - block.start[p];
  }
  Segment segment;
  segment.start.resize(static_cast<std::size_t>(key_count_) + 1);
  segment.start.back() = place.back();
  segment.origins.resize(place.back() + near_origins_lanes);
  segment.postings.resize(place.back());
  parallel_for(parts, threads, [&](std::size_t p) {
    const auto first_key = std::min(key_count_, static_cast<std::uint32_t>(p) * per_part);
    std::vector<std::span<const Entry>> runs;
    for (const Block& block : blocks)
      runs.emplace_back(block.entries.data() + block.start[p], block.start[p + 1] - block.start[p]);
    fill_part(segment, std::span<const std::span<const Entry>>(runs), first_key, std::min(key_count_, first_key + per_part),
              place[p]);
  });
  scene_count_ += static_cast<std::uint32_t>(scenes.size());
  segments_.push_back(std::move(segment));
}

std::size_t TriangleIndex::triangle_count() const {
  std::size_t count = 0;
  for (const Segment& s : segments_) count += s.postings.size();
  return count;
}

}  // namespace stemwise::treeloc
