#include "app/window/frame_damage.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace stemwise {
namespace {

constexpr int square_px = 32;
constexpr std::size_t most_rects = 12;

std::uint64_t mixed(std::uint64_t number, std::uint64_t with) {
  number = (number ^ with) * 0x9E3779B97F4A7C15ULL;
  return number ^ (number >> 29);
}

static_assert(sizeof(ImDrawVert) == 20, "position, place in the texture, colour");
std::uint64_t mixed(std::uint64_t number, const ImDrawVert& vertex) {
  std::uint64_t words[2];
  std::uint32_t last;
  std::memcpy(words, &vertex, sizeof words);
  std::memcpy(&last, reinterpret_cast<const char*>(&vertex) + sizeof words, sizeof last);
  return mixed(mixed(mixed(number, words[0]), words[1]), last);
}

/// Of each row of squares the runs that changed, joined with equal runs of the row above.
class RectJoiner {
 public:
  void add(const ScreenRect& run) {
    for (ScreenRect& rect : rects_)
      if (rect.left == run.left && rect.right == run.right && rect.bottom == run.top) {
        rect.bottom = run.bottom;
        return;
      }
    rects_.push_back(run);
  }
  std::vector<ScreenRect> take() {
    if (rects_.size() > most_rects) {
      ScreenRect all = rects_.front();
      for (const ScreenRect& r : rects_) all = {std::min(all.left, r.left), std::min(all.top, r.top), std::max(all.right, r.right), std::max(all.bottom, r.bottom)};
      rects_ = {all};
    }
    return std::move(rects_);
  }

 private:
  std::vector<ScreenRect> rects_;
};

}  // namespace

ScreenRect intersection(const ScreenRect& a, const ScreenRect& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

std::vector<ScreenRect> FrameDamage::update(const ImDrawData& data, int width, int height, LiveTextures live) {
  const bool is_new = squares_.empty() || width != width_ || height != height_;
  width_ = width;
  height_ = height;
  columns_ = (width + square_px - 1) / square_px;
  rows_ = (height + square_px - 1) / square_px;
  std::vector<std::uint64_t> before = std::move(squares_);
  squares_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 1);
  for (int i = 0; i < data.CmdListsCount; ++i)
    for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) mix_in(*data.CmdLists[i], command, live);
  if (is_new) return {{0, 0, width, height}};
  return rects_of(before);
}

void FrameDamage::mix_in(const ImDrawList& list, const ImDrawCmd& command, LiveTextures live) {
  const ImVec4& c = command.ClipRect;
  const ScreenRect clip = intersection({static_cast<int>(std::floor(c.x)), static_cast<int>(std::floor(c.y)), static_cast<int>(std::ceil(c.z)), static_cast<int>(std::ceil(c.w))},
                                       {0, 0, width_, height_});
  if (clip.is_empty()) return;
  const auto texture = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(command.TextureId));
  std::uint64_t state = mixed(1, texture);
  for (const LiveTexture& one : live)
    if (one.texture == texture) state = mixed(state, one.version);
  for (const float edge : {c.x, c.y, c.z, c.w}) state = mixed(state, static_cast<std::uint64_t>(static_cast<std::int64_t>(edge * 16.0F)));
  const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
  const ImDrawIdx* indices = list.IdxBuffer.Data + command.IdxOffset;
  for (unsigned int i = 0; i + 2 < command.ElemCount; i += 3) {
    const ImDrawVert &p = vertices[indices[i]], &q = vertices[indices[i + 1]], &r = vertices[indices[i + 2]];
    const auto [left, right] = std::minmax({p.pos.x, q.pos.x, r.pos.x});
    const auto [top, bottom] = std::minmax({p.pos.y, q.pos.y, r.pos.y});
    const ScreenRect box = intersection({static_cast<int>(std::floor(left)), static_cast<int>(std::floor(top)), static_cast<int>(std::ceil(right)) + 1, static_cast<int>(std::ceil(bottom)) + 1}, clip);
    if (!box.is_empty()) mix_into_squares(box, mixed(mixed(mixed(state, p), q), r));
  }
}

void FrameDamage::mix_into_squares(const ScreenRect& rect, std::uint64_t number) {
  for (int row = rect.top / square_px; row <= (rect.bottom - 1) / square_px; ++row)
    for (int column = rect.left / square_px; column <= (rect.right - 1) / square_px; ++column) {
      std::uint64_t& square = squares_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
      square = mixed(square, number);
    }
}

std::vector<ScreenRect> FrameDamage::rects_of(const std::vector<std::uint64_t>& before) const {
  RectJoiner joiner;
  for (int row = 0; row < rows_; ++row) {
    const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    for (int column = 0; column < columns_; ++column) {
      const int begin = column;
      while (column < columns_ && squares_[first + static_cast<std::size_t>(column)] != before[first + static_cast<std::size_t>(column)]) ++column;
      if (column > begin)
        joiner.add({begin * square_px, row * square_px, std::min(column * square_px, width_), std::min((row + 1) * square_px, height_)});
    }
  }
  return joiner.take();
}

}  // namespace stemwise
