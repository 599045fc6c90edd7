#include "core/survey/associate_observations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace stemwise {
namespace {

constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

/// Square cells that grow with what is put in: "who is within r of here" for points that move a little.
class GrowingGrid {
 public:
  explicit GrowingGrid(double cell_m) : cell_m_(cell_m) {}
  void add(const Eigen::Vector2d& at, std::size_t index) { cells_[key(column(at.x()), column(at.y()))].push_back(index); }
  void remove(const Eigen::Vector2d& at, std::size_t index) {
    std::vector<std::size_t>& cell = cells_[key(column(at.x()), column(at.y()))];
    cell.erase(std::find(cell.begin(), cell.end(), index));
  }
  bool same_cell(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
    return column(a.x()) == column(b.x()) && column(a.y()) == column(b.y());
  }
  /// Calls visit(index) for everything in the cells within one cell's size of `at`.
  template <class Visit>
  void around(const Eigen::Vector2d& at, Visit&& visit) const {
    const std::int64_t x = column(at.x()), y = column(at.y());
    for (std::int64_t dy = -1; dy <= 1; ++dy)
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        const auto cell = cells_.find(key(x + dx, y + dy));
        if (cell == cells_.end()) continue;
        for (const std::size_t index : cell->second) visit(index);
      }
  }

 private:
  std::int64_t column(double v_m) const { return static_cast<std::int64_t>(std::floor(v_m / cell_m_)); }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return (static_cast<std::uint64_t>(x) << 32) ^ (static_cast<std::uint64_t>(y) & 0xFFFFFFFFULL);
  }
  double cell_m_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

struct Candidate {
  bool reconstructed;
  double distance_sq;
  std::size_t observation, node;  ///< when merging: two nodes
};

bool best_first(const Candidate& a, const Candidate& b) {
  if (a.reconstructed != b.reconstructed) return a.reconstructed;
  if (a.distance_sq != b.distance_sq) return a.distance_sq < b.distance_sq;
  return a.observation != b.observation ? a.observation < b.observation : a.node < b.node;
}

class Association {
 public:
  Association(const FrameObservations& observations, std::span<const double> frame_weight, const AssociateSettings& settings)
      : observations_(observations), frame_weight_(frame_weight), settings_(settings), grid_(settings.radius_m) {}

  void grow();        ///< frame by frame; what meets no tree starts one
  void settle();      ///< robust positions; trees in order of their first observation, empty ones dropped
  void merge_near();  ///< joins trees that are too near to be two
  void reassign();    ///< every observation anew to the trees as they stand
  std::vector<TreeNode> take() && { return std::move(nodes_); }

 private:
  std::size_t frames() const { return observations_.first_of_frame.size() - 1; }
  double weight(std::size_t o) const { return observations_.all[o].weight * frame_weight_[observations_.all[o].frame]; }
  bool takes_part(std::size_t o) const { return observations_.all[o].reconstructed || !settings_.only_reconstructed; }
  std::vector<std::size_t> pair_frame(std::size_t frame);
  void join(std::size_t node, std::size_t observation);
  bool seen_side_by_side(const TreeNode& a, const TreeNode& b) const;

  const FrameObservations& observations_;
  std::span<const double> frame_weight_;
  AssociateSettings settings_;
  std::vector<TreeNode> nodes_;
  std::vector<double> total_weight_;
  std::vector<std::size_t> paired_in_;   ///< per tree, the round of pairing that last gave it an observation
  std::size_t round_of_pairing_ = 0;
  GrowingGrid grid_;
};

/// Per observation of the frame its tree or `nobody`, one-to-one: reconstructed stems choose first, then the nearest pairs.
std::vector<std::size_t> Association::pair_frame(std::size_t frame) {
  const std::size_t first = observations_.first_of_frame[frame], last = observations_.first_of_frame[frame + 1];
  std::vector<Candidate> candidates;
  const double limit_sq = settings_.radius_m * settings_.radius_m;
  for (std::size_t o = first; o < last; ++o) {
    if (!takes_part(o)) continue;
    const Eigen::Vector2d at = observations_.all[o].plane();
    grid_.around(at, [&](std::size_t node) {
      const double distance_sq = (nodes_[node].position - at).squaredNorm();
      if (distance_sq <= limit_sq) candidates.push_back({observations_.all[o].reconstructed, distance_sq, o, node});
    });
  }
  std::sort(candidates.begin(), candidates.end(), best_first);
  std::vector<std::size_t> node_of(last - first, nobody);
  ++round_of_pairing_;
  paired_in_.resize(nodes_.size(), 0);
  for (const Candidate& c : candidates) {
    if (node_of[c.observation - first] != nobody || paired_in_[c.node] == round_of_pairing_) continue;
    node_of[c.observation - first] = c.node;
    paired_in_[c.node] = round_of_pairing_;
  }
  return node_of;
}

/// A running weighted mean: good enough to find the next observation; the robust position comes when all are known.
void Association::join(std::size_t node, std::size_t observation) {
  TreeNode& tree = nodes_[node];
  tree.observations.push_back(observation);
  const double w = weight(observation);
  if (w <= 0.0) return;
  total_weight_[node] += w;
  const Eigen::Vector2d moved = tree.position + (observations_.all[observation].plane() - tree.position) * (w / total_weight_[node]);
  if (!grid_.same_cell(tree.position, moved)) {
    grid_.remove(tree.position, node);
    grid_.add(moved, node);
  }
  tree.position = moved;
}

void Association::grow() {
  for (std::size_t f = 0; f < frames(); ++f) {
    const std::vector<std::size_t> node_of = pair_frame(f);
    const std::size_t first = observations_.first_of_frame[f];
    for (std::size_t i = 0; i < node_of.size(); ++i) {
      if (node_of[i] != nobody) {
        join(node_of[i], first + i);
      } else if (takes_part(first + i) && weight(first + i) > 0.0) {
        grid_.add(observations_.all[first + i].plane(), nodes_.size());
        nodes_.push_back({observations_.all[first + i].plane(), {first + i}});
        total_weight_.push_back(weight(first + i));
      }
    }
  }
}

void Association::settle() {
  std::erase_if(nodes_, [](const TreeNode& node) { return node.observations.empty(); });
  for (TreeNode& node : nodes_) {
    std::sort(node.observations.begin(), node.observations.end());
    node.position = robust_position(observations_, node.observations, frame_weight_, settings_.noise_m);
  }
  std::sort(nodes_.begin(), nodes_.end(), [](const TreeNode& a, const TreeNode& b) { return a.observations.front() < b.observations.front(); });
  grid_ = GrowingGrid(settings_.radius_m);
  for (std::size_t n = 0; n < nodes_.size(); ++n) grid_.add(nodes_[n].position, n);
}

/// In more than a tenth of the frames that saw the rarer one: then they are two trees, however near.
bool Association::seen_side_by_side(const TreeNode& a, const TreeNode& b) const {
  std::size_t together = 0;
  auto i = a.observations.begin(), j = b.observations.begin();
  while (i != a.observations.end() && j != b.observations.end()) {
    const std::size_t fa = observations_.all[*i].frame, fb = observations_.all[*j].frame;
    together += fa == fb ? 1 : 0;
    if (fa <= fb) ++i;
    if (fb <= fa) ++j;
  }
  return 10 * together > std::min(a.observations.size(), b.observations.size());
}

void Association::merge_near() {
  std::vector<Candidate> pairs;
  const double limit_sq = settings_.merge_radius_m * settings_.merge_radius_m;
  for (std::size_t n = 0; n < nodes_.size(); ++n)
    grid_.around(nodes_[n].position, [&](std::size_t other) {
      const double distance_sq = (nodes_[n].position - nodes_[other].position).squaredNorm();
      if (other > n && distance_sq <= limit_sq) pairs.push_back({true, distance_sq, n, other});
    });
  std::sort(pairs.begin(), pairs.end(), best_first);
  for (const Candidate& pair : pairs) {
    TreeNode &a = nodes_[pair.observation], &b = nodes_[pair.node];
    if (a.observations.empty() || b.observations.empty() || seen_side_by_side(a, b)) continue;
    TreeNode& into = a.observations.size() >= b.observations.size() ? a : b;
    TreeNode& from = &into == &a ? b : a;
    into.observations.insert(into.observations.end(), from.observations.begin(), from.observations.end());
    std::sort(into.observations.begin(), into.observations.end());
    from.observations.clear();
  }
  settle();
}

/// Observations that meet no tree any more (rare: trees have moved) are left out.
void Association::reassign() {
  for (TreeNode& node : nodes_) node.observations.clear();
  for (std::size_t f = 0; f < frames(); ++f) {
    const std::vector<std::size_t> node_of = pair_frame(f);
    for (std::size_t i = 0; i < node_of.size(); ++i)
      if (node_of[i] != nobody) nodes_[node_of[i]].observations.push_back(observations_.first_of_frame[f] + i);
  }
  settle();
}

/// Reconstructed stems alone where there are three or more: a partly seen surface pulls the centre towards the sensor.
std::vector<std::size_t> best_members(const FrameObservations& observations, std::span<const std::size_t> members) {
  std::vector<std::size_t> best;
  for (const std::size_t o : members)
    if (observations.all[o].reconstructed) best.push_back(o);
  return best.size() >= 3 ? best : std::vector<std::size_t>(members.begin(), members.end());
}

}  // namespace

Eigen::Vector2d robust_position(const FrameObservations& observations, std::span<const std::size_t> members,
                                std::span<const double> frame_weight, double noise_m) {
  const std::vector<std::size_t> best = best_members(observations, members);
  const auto weight = [&](std::size_t o) { return observations.all[o].weight * std::max(1e-6, frame_weight[observations.all[o].frame]); };
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double total = 0.0;
  for (const std::size_t o : best) {
    at += weight(o) * observations.all[o].plane();
    total += weight(o);
  }
  at /= total;
  for (int round = 0; round < 10 && best.size() > 2; ++round) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    total = 0.0;
    for (const std::size_t o : best) {
      const double distance_sq = (observations.all[o].plane() - at).squaredNorm();
      const double w = weight(o) / (1.0 + distance_sq * observations.all[o].weight / (noise_m * noise_m));
      sum += w * observations.all[o].plane();
      total += w;
    }
    const Eigen::Vector2d next = sum / total;
    const bool still = (next - at).norm() < 1e-4;
    at = next;
    if (still) break;
  }
  return at;
}

std::vector<TreeNode> associate_observations(const FrameObservations& observations, std::span<const double> frame_weight,
                                             const AssociateSettings& settings) {
  Association association(observations, frame_weight, settings);
  association.grow();
  association.settle();
  for (int round = 0; round < settings.rounds; ++round) {
    association.merge_near();
    association.reassign();
  }
  return std::move(association).take();
}

}  // namespace stemwise
