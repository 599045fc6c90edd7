#include "core/treeloc/vote_scenes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace stemwise::treeloc {
namespace {

constexpr int directions = 256;
constexpr int directions_per_bin = directions / SceneVote::yaw_bins;

bool is_close(std::uint8_t a, std::uint8_t b, int tolerance) {
  return std::abs(static_cast<int>(a) - static_cast<int>(b)) <= tolerance;
}

}  // namespace

Fields VoteSettings::fields(const std::string& prefix) {
  return {{prefix + ".tau_dbh_m", "m", "Diameters of corresponding vertices differ by at most this", &tau_dbh_m},
          {prefix + ".gate_m", "m", "Triangles that put the two origins farther apart do not vote", &gate_m},
          {prefix + ".verified", "", "Scenes with the highest yaw peaks that are verified", &verified}};
}

SceneVote::SceneVote(const VoteSettings& settings) : settings_(settings) {
  const auto gate_cm = static_cast<std::int32_t>(std::lround(settings_.gate_m * 100.0));
  gate_sq_cm_ = gate_cm * gate_cm;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / directions;
    cosine_.push_back(static_cast<float>(std::cos(angle)));
    sine_.push_back(static_cast<float>(std::sin(angle)));
  }
}

/// Adds the places of the postings of `t` whose origin lies within the gate, and asks for the postings themselves.
void SceneVote::collect_near(const TriangleIndex& index, std::size_t segment, const Triangle& t, std::uint32_t number) {
  const auto [first, count] = index.range(segment, t.key);
  const TriangleOrigin* origins = index.origins(segment) + first;
  const Posting* postings = index.postings(segment) + first;
  for (std::uint32_t done = 0; done < count; done += near_origins_lanes) {
    unsigned mask = near_origins_mask(origins + done, t.origin, gate_sq_cm_);
    if (count - done < near_origins_lanes) mask &= (1U << (count - done)) - 1U;
    for (; mask != 0; mask &= mask - 1) {
      const std::uint32_t place = done + static_cast<std::uint32_t>(std::countr_zero(mask));
      __builtin_prefetch(postings + place);
      near_.push_back({first + place, number});
    }
  }
}

/// The near postings whose diameters fit vote.
void SceneVote::vote_near(const TriangleIndex& index, std::size_t segment, std::span<const Triangle> query,
                          std::uint32_t scene_limit) {
  const int tau_dbh = static_cast<int>(std::lround(settings_.tau_dbh_m * 100.0));
  const TriangleOrigin* origins = index.origins(segment);
  const Posting* postings = index.postings(segment);
  for (const Near& near : near_) {
    const Triangle& t = query[near.triangle];
    const Posting& p = postings[near.place];
    if (!is_close(t.dbh_cm[0], p.dbh_cm[0], tau_dbh) || !is_close(t.dbh_cm[1], p.dbh_cm[1], tau_dbh) ||
        !is_close(t.dbh_cm[2], p.dbh_cm[2], tau_dbh) || p.scene >= scene_limit) {
      continue;
    }
    const TriangleOrigin& origin = origins[near.place];
    const auto yaw = static_cast<std::uint8_t>(p.yaw - t.yaw);
    if (total_[p.scene]++ == 0) touched_.push_back(p.scene);
    ++histogram_[p.scene * yaw_bins + yaw / directions_per_bin];
    hits_.push_back({p.scene, static_cast<std::int16_t>(t.origin.x_cm - origin.x_cm),
                     static_cast<std::int16_t>(t.origin.y_cm - origin.y_cm), p.yaw, yaw});
  }
}

void SceneVote::collect_hits(const TriangleIndex& index, std::span<const Triangle> query, std::uint32_t scene_limit) {
  constexpr std::size_t per_block = 32, ahead = 8;
  for (std::size_t segment = 0; segment < index.segment_count(); ++segment) {
    for (std::size_t first = 0; first < query.size(); first += per_block) {
      const std::size_t end = std::min(query.size(), first + per_block);
      near_.clear();
      for (std::size_t i = first; i < end; ++i) {
        // The index is far larger than the caches: ask ahead.
        if (i + 2 * ahead < query.size()) index.prefetch_range(segment, query[i + 2 * ahead].key);
        if (i + ahead < query.size()) index.prefetch_origins(segment, query[i + ahead].key);
        collect_near(index, segment, query[i], static_cast<std::uint32_t>(i));
      }
      vote_near(index, segment, query, scene_limit);
    }
  }
}

/// The highest of the histogram's circular sums of three bins.
int SceneVote::peak_of(std::uint32_t scene, int& bin) const {
  const std::uint16_t* h = histogram_.data() + static_cast<std::size_t>(scene) * yaw_bins;
  int best = -1;
  for (int b = 0; b < yaw_bins; ++b) {
    const int sum = h[(b + yaw_bins - 1) % yaw_bins] + h[b] + h[(b + 1) % yaw_bins];
    if (sum > best) best = sum, bin = b;
  }
  return best;
}

void SceneVote::rank_scenes() {
  const auto better = [](const Ranked& a, const Ranked& b) { return a.votes != b.votes ? a.votes > b.votes : a.scene < b.scene; };
  ranked_.clear();
  const auto wanted = static_cast<std::size_t>(std::max(1, settings_.verified));
  for (const std::uint32_t scene : touched_) {
    // A heap of the best: its front is the worst of them. A scene's peak is at most its total.
    if (ranked_.size() == wanted && static_cast<int>(total_[scene]) < ranked_.front().votes) continue;
    Ranked r{scene, 0, 0};
    r.votes = peak_of(scene, r.bin);
    if (ranked_.size() == wanted) {
      if (!better(r, ranked_.front())) continue;
      std::pop_heap(ranked_.begin(), ranked_.end(), better);
      ranked_.pop_back();
    }
    ranked_.push_back(r);
    std::push_heap(ranked_.begin(), ranked_.end(), better);
  }
  std::sort(ranked_.begin(), ranked_.end(), better);
}

/// Puts the hits of the ranked scenes near their yaw peak side by side, scene after scene.
void SceneVote::sort_hits_by_rank() {
  for (std::size_t r = 0; r < ranked_.size(); ++r) rank_[ranked_[r].scene] = static_cast<std::int32_t>(r);
  const auto rank_near_peak = [&](const Hit& hit) {
    const std::int32_t r = rank_[hit.scene];
    if (r < 0) return r;
    const int off = (hit.yaw_difference / directions_per_bin - ranked_[static_cast<std::size_t>(r)].bin + yaw_bins) % yaw_bins;
    return off <= 1 || off == yaw_bins - 1 ? r : -1;
  };
  first_hit_.assign(ranked_.size() + 1, 0);
  for (const Hit& hit : hits_) {
    if (const std::int32_t r = rank_near_peak(hit); r >= 0) ++first_hit_[static_cast<std::size_t>(r) + 1];
  }
  for (std::size_t r = 0; r < ranked_.size(); ++r) first_hit_[r + 1] += first_hit_[r];
  hits_of_ranked_.resize(first_hit_.back());
  std::vector<std::uint32_t>& next = touched_;  // no longer needed
  next.assign(first_hit_.begin(), first_hit_.end());
  for (const Hit& hit : hits_) {
    if (const std::int32_t r = rank_near_peak(hit); r >= 0) hits_of_ranked_[next[static_cast<std::size_t>(r)]++] = hit;
  }
  for (const Ranked& r : ranked_) rank_[r.scene] = -1;
}

/// Mean yaw of the hits, and the mean of their shifts around the fullest 2 m square.
PlanarPose SceneVote::pose_from_hits(std::span<const Hit> hits, int bin) const {
  constexpr int cells = 32;
  std::array<std::uint16_t, cells * cells> count{};
  const float cell_m = std::max(0.5F, static_cast<float>(2.0 * settings_.gate_m / (cells - 2)));
  const auto cell_of = [&](float v) { return std::clamp(static_cast<int>(std::floor(v / cell_m)) + cells / 2, 0, cells - 1); };
  const auto shift_of = [&](const Hit& h) {
    const float c = cosine_[h.candidate_yaw], s = sine_[h.candidate_yaw];
    const float x = static_cast<float>(h.shift_x_cm) * 0.01F, y = static_cast<float>(h.shift_y_cm) * 0.01F;
    return std::pair(c * x - s * y, s * x + c * y);
  };
  for (const Hit& h : hits) {
    const auto [x, y] = shift_of(h);
    ++count[static_cast<std::size_t>(cell_of(y) * cells + cell_of(x))];
  }
  int best = -1, best_x = 0, best_y = 0;
  for (int y = 0; y + 1 < cells; ++y) {
    for (int x = 0; x + 1 < cells; ++x) {
      const auto at = static_cast<std::size_t>(y * cells + x);
      const int sum = count[at] + count[at + 1] + count[at + cells] + count[at + cells + 1];
      if (sum > best) best = sum, best_x = x, best_y = y;
    }
  }
  double sum_x = 0.0, sum_y = 0.0, sum_yaw = 0.0, used = 0.0;
  const int center = bin * directions_per_bin + directions_per_bin / 2;
  for (const Hit& h : hits) {
    const auto [x, y] = shift_of(h);
    const int cx = cell_of(x), cy = cell_of(y);
    if (cx < best_x || cx > best_x + 1 || cy < best_y || cy > best_y + 1) continue;
    sum_x += x;
    sum_y += y;
    sum_yaw += static_cast<std::int8_t>(static_cast<std::uint8_t>(h.yaw_difference - center));
    used += 1.0;
  }
  if (used == 0.0) return {};
  const double yaw = (center + sum_yaw / used) * 2.0 * std::numbers::pi / directions;
  return PlanarPose::from_yaw(sum_x / used, sum_y / used, yaw);
}

std::span<const VotedScene> SceneVote::vote(const TriangleIndex& index, std::span<const Triangle> query,
                                            std::uint32_t scene_limit) {
  const std::size_t scenes = index.scene_count();
  if (total_.size() < scenes) {
    total_.resize(scenes, 0);
    histogram_.resize(scenes * yaw_bins, 0);
    rank_.resize(scenes, -1);
  }
  hits_.clear();
  touched_.clear();
  collect_hits(index, query, scene_limit);
  rank_scenes();
  for (const std::uint32_t scene : touched_) {
    total_[scene] = 0;
    std::fill_n(histogram_.begin() + static_cast<std::ptrdiff_t>(scene) * yaw_bins, yaw_bins, std::uint16_t{0});
  }
  sort_hits_by_rank();
  result_.clear();
  for (std::size_t r = 0; r < ranked_.size(); ++r) {
    const std::span<const Hit> hits(hits_of_ranked_.data() + first_hit_[r], first_hit_[r + 1] - first_hit_[r]);
    result_.push_back({ranked_[r].scene, ranked_[r].votes, pose_from_hits(hits, ranked_[r].bin)});
  }
  return result_;
}

}  // namespace stemwise::treeloc
