#include "core/survey/assign_sparse.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>

namespace stemwise {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Least-cost assignment with cost = -gain; each left has a seat of its own at cost 0 ("alone").
class Assignment {
 public:
  Assignment(std::size_t lefts, std::size_t rights, std::span<const AssignmentEdge> edges)
      : edges_(edges), start_(lefts + 1, 0), chosen_(lefts, none), holder_(rights, none), u_(lefts, 0.0), v_(rights, 0.0), distance_(rights, infinite), reached_by_(rights, none), settled_(rights, 0) {
    for (const auto& e : edges)
      if (e.gain > 0.0) ++start_[e.left + 1];
    for (std::size_t l = 0; l < lefts; ++l) start_[l + 1] += start_[l];
    of_left_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t k = 0; k < edges.size(); ++k)
      if (edges[k].gain > 0.0) of_left_[next[edges[k].left]++] = k;
  }

  std::vector<std::size_t> solve() {
    for (std::size_t left = 0; left < chosen_.size(); ++left) seat(left);
    std::vector<std::size_t> result;
    for (const std::size_t k : chosen_)
      if (k != none) result.push_back(k);
    return result;
  }

 private:
  using Entry = std::pair<double, std::size_t>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

  double reduced(std::size_t k) const { return -edges_[k].gain - u_[edges_[k].left] - v_[edges_[k].right]; }

  void relax(std::size_t left, double at, Queue& queue) {
    for (std::size_t k = start_[left]; k < start_[left + 1]; ++k) {
      const std::size_t edge = of_left_[k], right = edges_[edge].right;
      if (settled_[right] != 0) continue;
      const double distance = at + std::max(0.0, reduced(edge));  // rounding must not make a step pay
      if (distance >= distance_[right]) continue;
      if (distance_[right] == infinite) touched_.push_back(right);
      distance_[right] = distance;
      reached_by_[right] = edge;
      queue.push({distance, right});
    }
  }

  /// Finds the cheapest way to seat one more left: at a free right, or by letting one left on the way stay alone.
  void seat(std::size_t first) {
    double least = 0.0;  // keeps reduced costs at or above zero
    for (std::size_t k = start_[first]; k < start_[first + 1]; ++k) least = std::min(least, -edges_[of_left_[k]].gain - v_[edges_[of_left_[k]].right]);
    u_[first] = least;
    Queue queue;
    std::size_t alone = first, end = none;
    double alone_at = -u_[first];
    std::vector<std::size_t> settled;
    relax(first, 0.0, queue);
    while (!queue.empty()) {
      const auto [at, right] = queue.top();
      queue.pop();
      if (settled_[right] != 0 || at > distance_[right]) continue;
      if (at >= alone_at) break;
      if (holder_[right] == none) {
        end = right;
        break;
      }
      settled.push_back(right);
      settled_[right] = 1;
      const std::size_t left = holder_[right];
      if (at - u_[left] < alone_at) alone_at = at - u_[left], alone = left;
      relax(left, at, queue);
    }
    const double total = end != none ? distance_[end] : alone_at;
    u_[first] += total;
    for (const std::size_t right : settled) {
      u_[holder_[right]] += total - distance_[right];
      v_[right] += distance_[right] - total;
    }
    move_seats(first, end, alone);
    for (const std::size_t right : touched_) distance_[right] = infinite, settled_[right] = 0;
    touched_.clear();
  }

  void move_seats(std::size_t first, std::size_t end, std::size_t alone) {
    std::size_t right = end;
    if (end == none) {
      if (alone == first) return;
      right = edges_[chosen_[alone]].right;
      chosen_[alone] = none;
    }
    while (true) {
      const std::size_t edge = reached_by_[right], left = edges_[edge].left;
      const std::size_t before = chosen_[left];
      chosen_[left] = edge;
      holder_[right] = left;
      if (left == first) return;
      right = edges_[before].right;
    }
  }

  std::span<const AssignmentEdge> edges_;
  std::vector<std::size_t> start_, of_left_;
  std::vector<std::size_t> chosen_;      ///< per left: its edge
  std::vector<std::size_t> holder_;      ///< per right: its left
  std::vector<double> u_, v_, distance_;
  std::vector<std::size_t> reached_by_;  ///< per right: the edge of the shortest path
  std::vector<std::uint8_t> settled_;
  std::vector<std::size_t> touched_;
};

}  // namespace

std::vector<std::size_t> assign_sparse(std::size_t lefts, std::size_t rights, std::span<const AssignmentEdge> edges) {
  return Assignment(lefts, rights, edges).solve();
}

}  // namespace stemwise
