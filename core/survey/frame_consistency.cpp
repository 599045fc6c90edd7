#include "core/survey/frame_consistency.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/planar_index.hpp"

namespace stemwise {
namespace {

constexpr double cell_m = 0.25;
constexpr std::size_t enough_support = 12;

/// The trees with what is asked of them for every frame: who saw them, and where they are.
struct Support {
  std::vector<Eigen::Vector2d> positions;
  std::vector<std::vector<std::size_t>> frames;  ///< ascending, per tree
  PlanarIndex index;

  /// Frames other than `frame` that saw the tree, capped: beyond a dozen more say nothing new.
  std::size_t others(std::size_t tree, std::size_t frame) const {
    const std::vector<std::size_t>& f = frames[tree];
    const std::size_t n = f.size() - (std::binary_search(f.begin(), f.end(), frame) ? 1 : 0);
    return std::min(n, enough_support);
  }
};

Support support_of(const FrameObservations& observations, std::span<const TreeNode> trees) {
  Support support;
  for (const TreeNode& tree : trees) {
    support.positions.push_back(tree.position);
    support.frames.emplace_back();
    for (const std::size_t o : tree.observations) support.frames.back().push_back(observations.all[o].frame);
  }
  support.index = PlanarIndex(support.positions, 2.0);
  return support;
}

/// Votes for the displacement that lays a frame's stems onto supported trees.
class DisplacementVote {
 public:
  explicit DisplacementVote(double radius_m)
      : half_(static_cast<int>(std::ceil(radius_m / cell_m))), side_(2 * half_ + 1), votes_(static_cast<std::size_t>(side_ * side_), 0.0) {}
  void add(const Eigen::Vector2d& displacement, double weight) {
    const int x = cell(displacement.x()), y = cell(displacement.y());
    if (std::max(std::abs(x), std::abs(y)) <= half_) at(x, y) += weight;
  }
  double smoothed(int x, int y) const {
    double sum = 0.0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (std::max(std::abs(x + dx), std::abs(y + dy)) <= half_) sum += votes_[place(x + dx, y + dy)];
    return sum;
  }
  /// The strongest displacement; it must beat zero by half.
  Eigen::Vector2d best() const {
    double most = 1.5 * smoothed(0, 0);
    Eigen::Vector2d found = Eigen::Vector2d::Zero();
    for (int y = -half_; y <= half_; ++y)
      for (int x = -half_; x <= half_; ++x)
        if (const double v = smoothed(x, y); v > most) {
          most = v;
          found = Eigen::Vector2d(x, y) * cell_m;
        }
    return found;
  }

 private:
  static int cell(double v_m) { return static_cast<int>(std::lround(v_m / cell_m)); }
  std::size_t place(int x, int y) const { return static_cast<std::size_t>((y + half_) * side_ + x + half_); }
  double& at(int x, int y) { return votes_[place(x, y)]; }
  int half_, side_;
  std::vector<double> votes_;
};

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median difference to the nearest tree that others saw, within `radius_m`, and the share of stems that have one.
struct Residual {
  Eigen::Vector2d median = Eigen::Vector2d::Zero();
  double agreement = 1.0;
  std::size_t stems = 0;
};

Residual residual_of(std::span<const Observation> stems, const Support& support, const Eigen::Vector2d& displacement, double radius_m) {
  std::vector<double> dx, dy;
  Residual residual;
  for (const Observation& o : stems) {
    if (!o.reconstructed) continue;
    ++residual.stems;
    double nearest_sq = radius_m * radius_m;
    Eigen::Vector2d difference = Eigen::Vector2d::Zero();
    bool found = false;
    support.index.within(o.plane() + displacement, radius_m, [&](std::size_t tree, double distance_sq) {
      if (distance_sq > nearest_sq || support.others(tree, o.frame) < 2) return;
      nearest_sq = distance_sq;
      difference = support.positions[tree] - o.plane();
      found = true;
    });
    if (!found) continue;
    dx.push_back(difference.x());
    dy.push_back(difference.y());
  }
  if (residual.stems == 0) return residual;
  residual.agreement = static_cast<double>(dx.size()) / static_cast<double>(residual.stems);
  if (!dx.empty()) residual.median = {median(dx), median(dy)};
  return residual;
}

Eigen::Vector2d vote(std::span<const Observation> stems, const Support& support, double radius_m) {
  DisplacementVote votes(radius_m);
  for (const Observation& o : stems) {
    if (!o.reconstructed) continue;
    support.index.within(o.plane(), radius_m, [&](std::size_t tree, double) {
      const std::size_t others = support.others(tree, o.frame);
      if (others > 0) votes.add(support.positions[tree] - o.plane(), static_cast<double>(others));
    });
  }
  return votes.best();
}

/// Per frame: whether another pose is near enough that the two must have seen the same trees.
std::vector<char> frames_with_neighbours(const FrameObservations& observations, double neighbour_m) {
  std::vector<Eigen::Vector2d> poses;
  for (const Eigen::Vector3d& p : observations.pose_positions) poses.push_back(p.head<2>());
  const PlanarIndex index(poses, neighbour_m);
  std::vector<char> has(poses.size(), 0);
  for (std::size_t f = 0; f < poses.size(); ++f)
    index.within(poses[f], neighbour_m, [&](std::size_t other, double) { has[f] = static_cast<char>(has[f] || other != f); });
  return has;
}

FrameConsistency judge(std::size_t frame, std::span<const Observation> stems, const Support& support, bool has_neighbour,
                       const FrameConsistencySettings& settings) {
  FrameConsistency judged;
  judged.frame = frame;
  constexpr std::size_t few = 5;
  const Eigen::Vector2d voted = vote(stems, support, settings.search_radius_m);
  const Residual residual = residual_of(stems, support, voted, settings.displaced_m);
  if (residual.stems < few) return judged;
  judged.agreement = residual.agreement;
  judged.displacement = residual.median;
  const double off_m = residual.median.norm();
  judged.weight = 1.0 / (1.0 + std::pow(off_m / settings.residual_scale_m, 2));
  const bool disagrees = has_neighbour && residual.agreement < settings.least_agreement;
  judged.contradicts = off_m > settings.doubtful_m || disagrees;
  if (off_m > settings.displaced_m || disagrees) judged.weight = 0.0;
  return judged;
}

}  // namespace

std::vector<FrameConsistency> judge_frames(const FrameObservations& observations, std::span<const TreeNode> trees,
                                           const FrameConsistencySettings& settings) {
  const Support support = support_of(observations, trees);
  const std::vector<char> has_neighbour = frames_with_neighbours(observations, settings.neighbour_m);
  std::vector<FrameConsistency> judged;
  for (std::size_t f = 0; f + 1 < observations.first_of_frame.size(); ++f)
    judged.push_back(judge(f, observations.of_frame(f), support, has_neighbour[f] != 0, settings));
  return judged;
}

}  // namespace stemwise
