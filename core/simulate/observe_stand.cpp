#include "core/simulate/observe_stand.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/planar_index.hpp"

namespace stemwise {
namespace {

constexpr double to_rad = std::numbers::pi / 180.0;

struct Extent {
  double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;
};

Extent extent_of(const std::vector<TrueTree>& trees) {
  Extent e{trees[0].x_m, trees[0].x_m, trees[0].y_m, trees[0].y_m};
  for (const auto& t : trees) e.x0 = std::min(e.x0, t.x_m), e.x1 = std::max(e.x1, t.x_m), e.y0 = std::min(e.y0, t.y_m), e.y1 = std::max(e.y1, t.y_m);
  return e;
}

/// A tree as it was measured, still in the truth's frame.
Stem measured(const TrueTree& tree, const TreeThen& then, const SimulateSettings& s, Random& random) {
  Stem stem;
  stem.x_m = tree.x_m + random.normal(0.0, s.position_noise_m);
  stem.y_m = tree.y_m + random.normal(0.0, s.position_noise_m);
  stem.dbh_m = std::max(1.0, then.dbh_cm + random.normal(0.0, s.dbh_noise_cm)) / 100.0;
  stem.species = tree.species;
  stem.status = then.state == TrueState::dead ? StemStatus::dead : StemStatus::alive;
  if (!s.heights_and_axes) return stem;
  stem.z_m = tree.z_m + random.normal(0.0, s.height_noise_m);
  const double sd = s.axis_noise_deg * to_rad;
  stem.axis = (tree.axis + Eigen::Vector3d(random.normal(0.0, sd), random.normal(0.0, sd), 0.0)).normalized();
  return stem;
}

Stem made_up(const Extent& e, const TrueTree& near, const SimulateSettings& s, Random& random) {
  TrueTree tree = near;
  tree.x_m = random.uniform(e.x0, e.x1), tree.y_m = random.uniform(e.y0, e.y1);
  return measured(tree, {TrueState::alive, random.uniform(s.smallest_dbh_cm, 40.0), ""}, s, random);
}

void move_into(Stem& stem, const RigidTransform& to) {
  const Eigen::Vector3d p = to * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
  stem.x_m = p.x(), stem.y_m = p.y();
  if (stem.z_m) stem.z_m = p.z();
  if (stem.axis) stem.axis = to.rotation * *stem.axis;
}

template <class T>
void shuffle(std::vector<T>& values, Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

constexpr std::size_t no_tree = static_cast<std::size_t>(-1);

struct Row {
  Stem stem;
  std::size_t tree = no_tree;
};

Frame frame_at(const TrajectoryPose& pose, std::int64_t number, const std::vector<TrueTree>& trees, const std::vector<std::size_t>& near, std::size_t survey,
               const RigidTransform& truth_from_frame, const SimulateSettings& s, Random& random) {
  Frame frame{number, pose, {}};
  const RigidTransform frame_from_truth = truth_from_frame.inverse();
  for (const std::size_t i : near) {
    if (trees[i].then[survey].state != TrueState::alive || random.uniform() < s.drop) continue;
    Stem stem = measured(trees[i], trees[i].then[survey], s, random);
    stem.number_clusters = 1 + static_cast<int>(random.below(4));
    stem.reconstructed = stem.number_clusters > 1;
    stem.score = 0.5 + 0.5 * random.uniform();
    stem.dbh_approximation_m = stem.dbh_m;
    if (!stem.reconstructed) stem.dbh_m.reset();
    move_into(stem, frame_from_truth);
    frame.stems.push_back(stem);
  }
  return frame;
}

}  // namespace

RigidTransform random_frame(const SimulateSettings& s, Random& random) {
  const double yaw = s.yaw_deg ? *s.yaw_deg * to_rad : random.uniform(-std::numbers::pi, std::numbers::pi);
  const double heading = random.uniform(0.0, 2.0 * std::numbers::pi), away = s.shift_m * std::sqrt(random.uniform());
  const double lean = random.uniform(0.0, 2.0 * std::numbers::pi), rise_m = s.tilt_deg > 0.0 ? random.uniform(-0.05, 0.05) * s.shift_m : 0.0;
  const Eigen::Matrix3d tilt = Eigen::AngleAxisd(s.tilt_deg * to_rad, Eigen::Vector3d(std::cos(lean), std::sin(lean), 0.0)).toRotationMatrix();
  return {tilt * rotation_from({0.0, 0.0, yaw}), {away * std::cos(heading), away * std::sin(heading), rise_m}};
}

SimulatedSurvey observe_stand(std::vector<TrueTree>& trees, std::size_t survey, Date date, const RigidTransform& truth_from_survey, const SimulateSettings& s,
                              Random& random) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const TreeThen& then = trees[i].then[survey];
    const double missed = random.uniform(), standing = random.uniform();
    const bool died_now = then.state == TrueState::dead && survey > 0 && trees[i].then[survey - 1].state == TrueState::alive;
    if (missed < s.drop || (then.state != TrueState::alive && !(died_now && standing < s.standing_dead))) continue;
    rows.push_back({measured(trees[i], then, s, random), i});
  }
  const auto extra = trees.empty() ? 0 : static_cast<std::size_t>(std::lround(s.false_stems * static_cast<double>(rows.size())));
  for (std::size_t k = 0; k < extra; ++k) rows.push_back({made_up(extent_of(trees), trees[random.below(trees.size())], s, random), no_tree});
  shuffle(rows, random);
  SimulatedSurvey result;
  result.truth_from_survey = truth_from_survey;
  result.inventory.date = date;
  result.inventory.name = std::to_string(year_of(date));
  const RigidTransform survey_from_truth = truth_from_survey.inverse();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Stem& stem = rows[k].stem;
    move_into(stem, survey_from_truth);
    stem.source_id = std::to_string(k + 1);
    stem.source_row = static_cast<std::int64_t>(k) + 2;
    stem.date = date;
    if (rows[k].tree != no_tree) trees[rows[k].tree].then[survey].source_id = stem.source_id;
    result.inventory.stems.push_back(stem);
  }
  return result;
}

FrameSet walk_through(const std::vector<TrueTree>& trees, std::size_t survey, const RigidTransform& truth_from_survey, const SimulateSettings& s, Random& random) {
  FrameSet set;
  if (trees.empty()) return set;
  constexpr double step_m = 4.0, lane_m = 25.0, sight_m = 25.0;
  std::vector<Eigen::Vector2d> places;
  for (const auto& t : trees) places.emplace_back(t.x_m, t.y_m);
  const PlanarIndex index(places, 10.0);
  const Extent e = extent_of(trees);
  const RigidTransform survey_from_truth = truth_from_survey.inverse();
  int lane = 0;
  for (double x = e.x0 + 0.5 * std::min(lane_m, e.x1 - e.x0); x < e.x1; x += lane_m, ++lane)
    for (double along = 0.0; along <= e.y1 - e.y0; along += step_m) {
      const double y = lane % 2 == 0 ? e.y0 + along : e.y1 - along;
      double ground_m = 0.0;
      const auto closest = index.nearest({x, y}, 1);
      if (!closest.empty()) ground_m = trees[closest[0]].z_m;
      const RollPitchYaw sway{random.normal(0.0, 0.03), random.normal(0.0, 0.03), (lane % 2 == 0 ? 0.5 : -0.5) * std::numbers::pi + random.normal(0.0, 0.1)};
      const RigidTransform truth_from_frame{rotation_from(sway), {x, y, ground_m + 1.6}};
      std::vector<std::size_t> near;
      index.within({x, y}, sight_m, [&](std::size_t i, double) { near.push_back(i); });
      std::sort(near.begin(), near.end());
      const TrajectoryPose pose{static_cast<double>(set.frames.size()) * step_m, survey_from_truth * truth_from_frame};
      set.frames.push_back(frame_at(pose, static_cast<std::int64_t>(set.frames.size()), trees, near, survey, truth_from_frame, s, random));
    }
  return set;
}

}  // namespace stemwise
