#include "core/survey/simulate_frames.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
#include "core/geometry/planar_index.hpp"

namespace stemwise {
namespace {

constexpr double sensor_height_m = 1.5;

std::vector<Eigen::Vector2d> positions_of(std::span<const Stem> stems) {
  std::vector<Eigen::Vector2d> positions;
  for (const Stem& stem : stems) positions.emplace_back(stem.x_m, stem.y_m);
  return positions;
}

double ground_m(std::span<const Stem> stems, const PlanarIndex& index, const Eigen::Vector2d& at) {
  double sum = 0.0;
  int n = 0;
  for (const std::size_t i : index.nearest(at, 4))
    if (stems[i].z_m) {
      sum += *stems[i].z_m;
      ++n;
    }
  return n > 0 ? sum / n : 0.0;
}

/// Sum of two slow waves: what a wrong ground model does along a walk.
double smooth_bias_m(std::size_t step, double size_m, std::uint64_t seed) {
  Random random(seed, 0xB1A5);
  const double phase_a = random.uniform(0, 6.28), phase_b = random.uniform(0, 6.28);
  const double s = static_cast<double>(step);
  return size_m * (0.6 * std::sin(s / 11.0 + phase_a) + 0.4 * std::sin(s / 3.7 + phase_b));
}

RigidTransform pose_at(std::span<const Eigen::Vector2d> path, std::size_t step, double ground, const SimulateFramesSettings& settings,
                       Random& random) {
  const Eigen::Vector2d ahead = step + 1 < path.size() ? path[step + 1] - path[step] : path[step] - path[step > 0 ? step - 1 : step];
  const double sway = radians(settings.tilt_deg);
  const RollPitchYaw angles{random.normal(0, sway), random.normal(0, sway), std::atan2(ahead.y(), ahead.x()) + random.normal(0, 0.1)};
  return {rotation_from(angles), {path[step].x(), path[step].y(), ground + sensor_height_m}};
}

Eigen::Vector3d noise(Random& random, double sd) { return {random.normal(0, sd), random.normal(0, sd), random.normal(0, sd)}; }

/// How one frame sees one tree; position and axis still in the survey's frame. `nearness` is 1 at the sensor, 0 at full range.
Stem see(const Stem& tree, double nearness, double height_bias_m, const SimulateFramesSettings& settings, Random& random) {
  Stem seen;
  seen.reconstructed = random.uniform() < settings.reconstruction * (1.0 + 2.0 * nearness) / 3.0;
  const double sd = settings.position_noise_m * (2.0 - nearness) * (seen.reconstructed ? 1.0 : 3.0);
  seen.x_m = tree.x_m + random.normal(0, sd);
  seen.y_m = tree.y_m + random.normal(0, sd);
  seen.z_m = tree.z_m.value_or(0.0) + height_bias_m + random.normal(0, settings.height_noise_m * (2.0 - nearness));
  const Eigen::Vector3d axis = tree.axis.value_or(Eigen::Vector3d::UnitZ());
  seen.axis = (axis + noise(random, radians(settings.axis_noise_deg) * (seen.reconstructed ? 1.0 : 2.0))).normalized();
  seen.number_clusters = 1 + static_cast<int>(random.below(seen.reconstructed ? 5 : 3));
  seen.score = std::clamp((seen.reconstructed ? 0.6 : 0.2) + random.normal(0, 0.2), 0.05, 1.0);
  if (const std::optional<double> dbh = tree.dbh_for_matching_m()) {
    if (seen.reconstructed && random.uniform() < 0.85) seen.dbh_m = std::max(0.02, *dbh + random.normal(0, settings.dbh_noise_m));
    seen.dbh_approximation_m = std::max(0.02, *dbh + random.normal(0, 3.0 * settings.dbh_noise_m));
  }
  seen.status = StemStatus::alive;
  return seen;
}

void into_frame(const RigidTransform& frame_from_survey, Stem& stem) {
  const Eigen::Vector3d at = frame_from_survey * Eigen::Vector3d(stem.x_m, stem.y_m, *stem.z_m);
  stem.x_m = at.x();
  stem.y_m = at.y();
  stem.z_m = at.z();
  stem.axis = frame_from_survey.rotation * *stem.axis;
}

Frame frame_at(std::span<const Stem> stems, const PlanarIndex& index, std::span<const Eigen::Vector2d> path, std::size_t step,
               const SimulateFramesSettings& settings) {
  Random random(settings.seed, step + 1);
  Frame frame;
  frame.number = static_cast<std::int64_t>(step);
  frame.pose.timestamp_s = static_cast<double>(step) * settings.step_m;
  frame.pose.survey_from_frame = pose_at(path, step, ground_m(stems, index, path[step]), settings, random);
  const RigidTransform frame_from_survey = frame.pose.survey_from_frame.inverse();
  const double bias_m = smooth_bias_m(step, settings.height_bias_m, settings.seed);
  std::vector<std::pair<std::size_t, double>> near;
  index.within(path[step], settings.range_m, [&](std::size_t i, double distance_sq) { near.emplace_back(i, std::sqrt(distance_sq)); });
  std::sort(near.begin(), near.end());
  for (const auto& [i, distance_m] : near) {
    const double nearness = 1.0 - distance_m / settings.range_m;
    if (!is_living(stems[i].status) || random.uniform() >= settings.detection * (1.0 + nearness) / 2.0) continue;
    Stem seen = see(stems[i], nearness, bias_m, settings, random);
    into_frame(frame_from_survey, seen);
    seen.source_row = static_cast<std::int64_t>(frame.stems.size()) + 2;
    seen.source_id = std::to_string(frame.stems.size());
    frame.stems.push_back(std::move(seen));
  }
  return frame;
}

}  // namespace

Fields SimulateFramesSettings::fields() {
  return {{"frames.step_m", "m", "Distance between simulated frames.", &step_m},
          {"frames.lane_m", "m", "Distance between the lanes of the simulated walk.", &lane_m},
          {"frames.range_m", "m", "Trees farther from the sensor are not seen.", &range_m},
          {"frames.detection", "", "Share of near trees that a frame sees.", &detection},
          {"frames.reconstruction", "", "Share of seen near trees that are reconstructed.", &reconstruction},
          {"frames.position_noise_m", "m", "Position noise of a near reconstructed stem.", &position_noise_m},
          {"frames.dbh_noise_m", "m", "DBH noise of one sighting.", &dbh_noise_m},
          {"frames.axis_noise_deg", "deg", "Axis noise of one sighting.", &axis_noise_deg},
          {"frames.height_noise_m", "m", "Base height noise of one sighting.", &height_noise_m},
          {"frames.height_bias_m", "m", "Smooth bias of base heights along the walk.", &height_bias_m},
          {"frames.tilt_deg", "deg", "Sway of the sensor in roll and pitch.", &tilt_deg}};
}

std::vector<Eigen::Vector2d> walk_over(std::span<const Stem> stems, const SimulateFramesSettings& settings) {
  if (stems.empty() || settings.step_m <= 0.0 || settings.lane_m <= 0.0) return {};
  const std::vector<Eigen::Vector2d> positions = positions_of(stems);
  Eigen::Vector2d low = positions[0], high = positions[0];
  for (const auto& p : positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const int along = (high - low).x() >= (high - low).y() ? 0 : 1, across = 1 - along;
  const int lanes = std::max(1, static_cast<int>(std::ceil((high - low)[across] / settings.lane_m)));
  const int steps = static_cast<int>((high - low)[along] / settings.step_m);
  std::vector<Eigen::Vector2d> path;
  for (int lane = 0; lane < lanes; ++lane)
    for (int step = 0; step <= steps; ++step) {
      Eigen::Vector2d at;
      const int s = lane % 2 == 0 ? step : steps - step;
      at[along] = low[along] + s * settings.step_m;
      at[across] = low[across] + (high - low)[across] * (lane + 0.5) / lanes;
      path.push_back(at);
    }
  return path;
}

FrameSet simulate_frames(std::span<const Stem> stems, std::span<const Eigen::Vector2d> path_m, const SimulateFramesSettings& settings) {
  FrameSet frames;
  const std::vector<Eigen::Vector2d> positions = positions_of(stems);
  const PlanarIndex index(positions, 5.0);
  for (std::size_t step = 0; step < path_m.size(); ++step) frames.frames.push_back(frame_at(stems, index, path_m, step, settings));
  return frames;
}

}  // namespace stemwise
