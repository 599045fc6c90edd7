#include "core/survey/summarise_tree.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

namespace stemwise {
namespace {

const Stem& stem_of(const SummaryContext& context, const Observation& o) { return context.frames.frames[o.frame].stems[o.stem]; }

/// More than five partial observations of one stem are two stems taken for one (measured: their positions are off by 0.2 m).
bool taken_for_one(const Stem& stem) { return stem.number_clusters > 5; }

/// Trust in a diameter or an axis: a surface seen from many sides, near, with a good fit.
double surface_weight(const Stem& stem) {
  const double range_m = std::hypot(stem.x_m, stem.y_m);
  return (0.1 + stem.score) * std::min(5, stem.number_clusters) * (taken_for_one(stem) ? 0.1 : 1.0) / (1.0 + range_m / 10.0);
}

std::optional<double> diameter(const TreeNode& tree, const SummaryContext& context, std::optional<double> Stem::*which, bool only_reconstructed) {
  std::vector<Weighted> values;
  for (const std::size_t i : tree.observations) {
    const Observation& o = context.observations.all[i];
    const Stem& stem = stem_of(context, o);
    if (!(stem.*which) || (only_reconstructed && !o.reconstructed)) continue;
    values.push_back({*(stem.*which), surface_weight(stem)});
  }
  if (values.empty()) return std::nullopt;
  return weighted_median(std::move(values));
}

std::optional<double> base_height(const TreeNode& tree, const SummaryContext& context) {
  std::vector<Weighted> values;
  for (const std::size_t i : tree.observations) {
    const Observation& o = context.observations.all[i];
    if (o.has_height) values.push_back({o.position.z(), o.weight * std::max(1e-6, context.frame_height_weight[o.frame])});
  }
  if (values.empty()) return std::nullopt;
  return weighted_median(std::move(values));
}

/// Dominant line of the axes, reweighted twice so that a wild one counts little. Level frame.
std::optional<Eigen::Vector3d> axis_of(const TreeNode& tree, const SummaryContext& context, bool only_reconstructed) {
  std::optional<Eigen::Vector3d> line;
  for (int round = 0; round < 3; ++round) {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const std::size_t i : tree.observations) {
      const Observation& o = context.observations.all[i];
      if (!o.has_axis || (only_reconstructed && !o.reconstructed)) continue;
      const double off = line ? line->cross(o.axis).norm() / 0.05 : 0.0;  // 0.05 rad: about 3 degrees, the usual spread
      scatter += surface_weight(stem_of(context, o)) / (1.0 + off * off) * o.axis * o.axis.transpose();
    }
    if (scatter.trace() <= 0.0) return std::nullopt;
    line = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
    if (line->z() < 0.0) *line = -*line;
  }
  return line;
}

/// "frames 12 to 37, 102 to 110": runs broken where the tree was out of sight for more than 20 frames.
std::string seen_in(const TreeNode& tree, const SummaryContext& context) {
  std::string text;
  std::int64_t first = 0, last = 0;
  const auto close = [&] { text += (text.empty() ? "" : ", ") + std::to_string(first) + (last > first ? " to " + std::to_string(last) : ""); };
  for (const std::size_t i : tree.observations) {
    const std::int64_t number = context.frames.frames[context.observations.all[i].frame].number;
    if (i != tree.observations.front() && number <= last + 20) {
      last = number;
      continue;
    }
    if (i != tree.observations.front()) close();
    first = last = number;
  }
  close();
  return "frames " + text;
}

void describe_sightings(const TreeNode& tree, const SummaryContext& context, Stem& stem) {
  stem.score = 0.0;
  stem.number_clusters = 0;
  stem.reconstructed = false;
  for (const std::size_t i : tree.observations) {
    const Stem& seen = stem_of(context, context.observations.all[i]);
    stem.reconstructed = stem.reconstructed || seen.reconstructed;
  }
  for (const std::size_t i : tree.observations) {
    const Stem& seen = stem_of(context, context.observations.all[i]);
    if (seen.reconstructed != stem.reconstructed) continue;
    stem.score = std::max(stem.score, seen.score);
    if (!taken_for_one(seen)) stem.number_clusters = std::max(stem.number_clusters, seen.number_clusters);
  }
  stem.number_clusters = std::max(1, stem.number_clusters);
  stem.times_seen = static_cast<int>(tree.observations.size());
  stem.note = seen_in(tree, context);
}

}  // namespace

double weighted_median(std::vector<Weighted> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  double total = 0.0;
  for (const Weighted& v : values) total += v.weight;
  double below = 0.0;
  for (const Weighted& v : values) {
    below += v.weight;
    if (2.0 * below >= total) return v.value;
  }
  return values.back().value;
}

Stem summarise_tree(const TreeNode& tree, const SummaryContext& context) {
  Stem stem;
  describe_sightings(tree, context, stem);
  const std::optional<double> height = base_height(tree, context);
  const RigidTransform survey_from_level = context.observations.level_from_survey.inverse();
  const Eigen::Vector3d at = survey_from_level * Eigen::Vector3d(tree.position.x(), tree.position.y(), height.value_or(0.0));
  stem.x_m = at.x();
  stem.y_m = at.y();
  if (height) stem.z_m = at.z();
  if (const auto axis = axis_of(tree, context, stem.reconstructed)) stem.axis = survey_from_level.rotation * *axis;
  stem.dbh_m = diameter(tree, context, &Stem::dbh_m, true);
  stem.dbh_approximation_m = diameter(tree, context, &Stem::dbh_approximation_m, stem.reconstructed);
  return stem;
}

}  // namespace stemwise
