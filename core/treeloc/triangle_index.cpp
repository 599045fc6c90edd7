#include "core/treeloc/triangle_index.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"

namespace stemwise::treeloc {
namespace {

constexpr std::size_t scenes_per_block = 64;

/// The triangles of a run of scenes, described by one thread.
struct Block {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> scene_end;
};

std::vector<Block> describe_blocks(std::span<const Scene> scenes, const TriangleSettings& settings, int threads) {
  std::vector<Block> blocks((scenes.size() + scenes_per_block - 1) / scenes_per_block);
  parallel_for(blocks.size(), threads, [&](std::size_t b) {
    TriangleMaker maker(settings);
    const std::size_t first = b * scenes_per_block;
    const std::size_t last = std::min(first + scenes_per_block, scenes.size());
    for (std::size_t s = first; s < last; ++s) {
      const auto& made = maker.make(scenes[s]);
      blocks[b].triangles.insert(blocks[b].triangles.end(), made.begin(), made.end());
      blocks[b].scene_end.push_back(static_cast<std::uint32_t>(blocks[b].triangles.size()));
    }
  });
  return blocks;
}

Posting posting_of(const Triangle& t, std::uint32_t scene) {
  return {scene, t.yaw, {t.dbh_cm[0], t.dbh_cm[1], t.dbh_cm[2]}};
}

}  // namespace

void TriangleIndex::add(std::span<const Scene> scenes, int threads) {
  auto blocks = describe_blocks(scenes, settings_, threads);
  Segment segment;
  segment.start.assign(static_cast<std::size_t>(key_count_) + 1, 0);
  std::size_t total = 0;
  for (const Block& block : blocks) {
    for (const Triangle& t : block.triangles) ++segment.start[t.key + 1];
    total += block.triangles.size();
  }
  for (std::size_t k = 1; k < segment.start.size(); ++k) segment.start[k] += segment.start[k - 1];
  segment.origins.resize(total + near_origins_lanes);
  segment.postings.resize(total);
  std::vector<std::uint32_t> next(segment.start.begin(), segment.start.end() - 1);
  std::uint32_t scene = scene_count_;
  for (Block& block : blocks) {
    std::size_t t = 0;
    for (const std::uint32_t end : block.scene_end) {
      for (; t < end; ++t) {
        const std::uint32_t place = next[block.triangles[t].key]++;
        segment.origins[place] = block.triangles[t].origin;
        segment.postings[place] = posting_of(block.triangles[t], scene);
      }
      ++scene;
    }
    block = Block();  // give the memory back as we go
  }
  scene_count_ = scene;
  segments_.push_back(std::move(segment));
}

std::size_t TriangleIndex::triangle_count() const {
  std::size_t count = 0;
  for (const Segment& s : segments_) count += s.postings.size();
  return count;
}

}  // namespace stemwise::treeloc
