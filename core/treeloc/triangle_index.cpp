#include "core/treeloc/triangle_index.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/base/parallel.hpp"

namespace stemwise::treeloc {
namespace {

// The triangles of a block and the keys of a part each stay in a core's cache while they are sorted.
constexpr std::uint32_t scenes_per_block = 32;
constexpr std::size_t blocks_per_task = 4;
constexpr std::uint32_t most_parts = 256;

/// How keys are split into parts: by their upper bits, for a division per triangle would cost as much as the rest.
struct KeyParts {
  explicit KeyParts(std::uint32_t keys) : key_count(keys) {
    while ((key_count >> shift) >= most_parts) ++shift;
    count = (key_count >> shift) + 1;
  }
  std::uint32_t first_key(std::uint32_t part) const { return std::min(key_count, part << shift); }
  std::uint32_t key_count, shift = 0, count = 0;
};

/// A triangle within its block and part.
struct Entry {
  std::uint32_t key_and_scene;  ///< key within the part times scenes_per_block, plus the scene within the block
  TriangleOrigin origin;
  std::uint8_t yaw;
  std::uint8_t dbh_cm[3];
};
constexpr std::uint32_t key_of(const Entry& e) { return e.key_and_scene / scenes_per_block; }
constexpr std::uint32_t scene_of(const Entry& e) { return e.key_and_scene % scenes_per_block; }

/// The triangles of a run of scenes, part by part; within a part in order of scene.
struct Block {
  FlatArray<Entry> entries;
  std::array<std::uint32_t, most_parts + 1> start{};
};

/// A triangle with the scene of its block, before it is sorted.
struct Made {
  std::uint32_t key, scene;
  TriangleOrigin origin;
  std::uint8_t yaw;
  std::uint8_t dbh_cm[3];
};

/// The triangles of a block of scenes as they are made, counted by part.
class MadeTriangles {
public:
  explicit MadeTriangles(const KeyParts& parts) : parts_(parts) {}

  void clear() {
    made_.clear();
    counts_.fill(0);
  }
  void add(std::uint32_t scene, std::span<const Triangle> triangles) {
    const std::size_t first = made_.size();
    made_.resize(first + triangles.size());
    Made* out = made_.data() + first;
    for (const Triangle& t : triangles) {
      ++counts_[t.key >> parts_.shift];
      *out++ = {t.key, scene, t.origin, t.yaw, {t.dbh_cm[0], t.dbh_cm[1], t.dbh_cm[2]}};
    }
  }
  Block sorted() const {
    Block block;
    for (std::size_t p = 0; p < most_parts; ++p) block.start[p + 1] = block.start[p] + counts_[p];
    block.entries = FlatArray<Entry>(made_.size());
    auto next = block.start;
    Entry* const entries = block.entries.data();
    const std::uint32_t shift = parts_.shift, within_part = (std::uint32_t{1} << shift) - 1;
    for (const Made& m : made_)
      entries[next[m.key >> shift]++] = {
          (m.key & within_part) * scenes_per_block + m.scene, m.origin, m.yaw, {m.dbh_cm[0], m.dbh_cm[1], m.dbh_cm[2]}};
    return block;
  }

private:
  const KeyParts& parts_;
  std::vector<Made> made_;
  std::array<std::uint32_t, most_parts> counts_{};
};

std::vector<Block> describe_blocks(std::span<const Scene> scenes, const TriangleSettings& settings, const KeyParts& parts,
                                   int threads) {
  std::vector<Block> blocks((scenes.size() + scenes_per_block - 1) / scenes_per_block);
  parallel_for((blocks.size() + blocks_per_task - 1) / blocks_per_task, threads, [&](std::size_t task) {
    TriangleMaker maker(settings);
    MadeTriangles made(parts);
    const std::size_t end = std::min((task + 1) * blocks_per_task, blocks.size());
    for (std::size_t b = task * blocks_per_task; b < end; ++b) {
      made.clear();
      const auto of_block = scenes.subspan(b * scenes_per_block, std::min<std::size_t>(scenes_per_block, scenes.size() - b * scenes_per_block));
      for (std::uint32_t s = 0; s < of_block.size(); ++s) made.add(s, maker.make(of_block[s]));
      blocks[b] = made.sorted();
    }
  });
  return blocks;
}

std::span<const Entry> run_of(const Block& block, std::uint32_t part) {
  return {block.entries.data() + block.start[part], block.start[part + 1] - block.start[part]};
}

/// Fills one part of the keys; `place` is where its triangles begin.
void fill_part(IndexSegment& segment, std::span<const Block> blocks, const KeyParts& parts, std::uint32_t part,
               std::uint32_t place) {
  const std::uint32_t first_key = parts.first_key(part), end_key = parts.first_key(part + 1);
  std::vector<std::uint32_t> next(end_key - first_key, 0);
  for (const Block& block : blocks) {
    for (const Entry& e : run_of(block, part)) ++next[key_of(e)];
  }
  for (std::uint32_t key = first_key; key < end_key; ++key) {
    const std::uint32_t count = next[key - first_key];
    segment.start[key] = next[key - first_key] = place;
    place += count;
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const auto first_scene = static_cast<std::uint32_t>(b) * scenes_per_block;
    for (const Entry& e : run_of(blocks[b], part)) {
      const std::uint32_t at = next[key_of(e)]++;
      segment.origins[at] = e.origin;
      segment.postings[at] = {first_scene + scene_of(e), e.yaw, {e.dbh_cm[0], e.dbh_cm[1], e.dbh_cm[2]}};
    }
  }
}

}  // namespace

IndexSegment index_scenes(std::span<const Scene> scenes, const TriangleSettings& settings, int threads) {
  const KeyParts parts(TriangleKeys(settings).count());
  const auto blocks = describe_blocks(scenes, settings, parts, threads);
  std::array<std::uint32_t, most_parts + 1> place{};
  for (std::uint32_t p = 0; p < parts.count; ++p) {
    place[p + 1] = place[p];
    for (const Block& block : blocks) place[p + 1] += block.start[p + 1] - block.start[p];
  }
  const std::uint32_t triangles = place[parts.count];
  IndexSegment segment{static_cast<std::uint32_t>(scenes.size()), FlatArray<std::uint32_t>(std::size_t{parts.key_count} + 1),
                       FlatArray<TriangleOrigin>(std::size_t{triangles} + near_origins_lanes), FlatArray<Posting>(triangles)};
  segment.start[parts.key_count] = triangles;
  std::fill_n(segment.origins.data() + triangles, near_origins_lanes, TriangleOrigin{});
  parallel_for(parts.count, threads, [&](std::size_t p) {
    fill_part(segment, blocks, parts, static_cast<std::uint32_t>(p), place[p]);
  });
  return segment;
}

void TriangleIndex::add(IndexSegment segment) {
  if (segment.start.size() != std::size_t{key_count_} + 1) throw std::invalid_argument("an index of other triangle settings");
  if (scene_count_ > 0) {
    for (Posting& posting : segment.postings.span()) posting.scene += scene_count_;
  }
  scene_count_ += segment.scene_count;
  segments_.push_back(std::move(segment));
}

std::size_t TriangleIndex::triangle_count() const {
  std::size_t count = 0;
  for (const IndexSegment& s : segments_) count += s.postings.size();
  return count;
}

}  // namespace stemwise::treeloc
