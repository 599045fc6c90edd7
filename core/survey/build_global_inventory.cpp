#include "core/survey/build_global_inventory.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/survey/associate_observations.hpp"
#include "core/survey/frame_consistency.hpp"
#include "core/survey/frame_observations.hpp"
#include "core/survey/summarise_tree.hpp"

namespace stemwise {
namespace {

AssociateSettings associate_settings(const GlobalInventorySettings& settings, bool only_reconstructed) {
  AssociateSettings s;
  s.radius_m = settings.association_radius_m;
  s.merge_radius_m = settings.merge_radius_m;
  s.noise_m = settings.position_noise_m;
  s.only_reconstructed = only_reconstructed;
  return s;
}

/// Positions noisier than the settings expect scatter one tree's sightings over several: then everything that says "near"
/// is widened. Trees that one frame sees side by side stay two all the same.
GlobalInventorySettings fitted_to_noise(GlobalInventorySettings settings, const FrameObservations& observations) {
  constexpr double widest = 2.5, median_of_plane = 1.18;  // of the distance of a plane normal with standard deviation 1
  const std::vector<double> equal(observations.pose_positions.size(), 1.0);
  std::vector<double> off_m;
  for (const TreeNode& tree : associate_observations(observations, equal, associate_settings(settings, true)))
    for (const std::size_t o : tree.observations)
      if (tree.observations.size() >= 3) off_m.push_back((observations.all[o].plane() - tree.position).norm());
  if (off_m.size() < 30) return settings;
  const auto middle = off_m.begin() + static_cast<std::ptrdiff_t>(off_m.size() / 2);
  std::nth_element(off_m.begin(), middle, off_m.end());
  const double wider = std::clamp(*middle / (1.25 * median_of_plane * settings.position_noise_m), 1.0, widest);
  settings.association_radius_m *= wider;
  settings.merge_radius_m *= wider;
  settings.position_noise_m *= wider;
  return settings;
}

/// A first grouping of the good stems alone tells which frames contradict the others.
std::vector<FrameConsistency> check_frames(const FrameObservations& observations, const GlobalInventorySettings& settings) {
  const std::vector<double> equal(observations.pose_positions.size(), 1.0);
  const std::vector<TreeNode> trees = associate_observations(observations, equal, associate_settings(settings, true));
  FrameConsistencySettings check;
  check.search_radius_m = settings.search_radius_m;
  check.displaced_m = settings.displaced_m;
  check.doubtful_m = settings.doubtful_m;
  return judge_frames(observations, trees, check);
}

/// Stems of displaced frames are counted where they belong, though they move no tree.
void put_back(const std::vector<FrameConsistency>& judged, const GlobalInventorySettings& settings, FrameObservations& observations) {
  for (Observation& o : observations.all)
    if (judged[o.frame].displacement.norm() > settings.displaced_m) o.position.head<2>() += judged[o.frame].displacement;
}

/// Per frame, the median difference of its base heights to those of the trees (method.md 12: off by up to metres).
std::vector<double> height_biases(const FrameObservations& observations, const std::vector<TreeNode>& trees) {
  std::vector<std::vector<Weighted>> differences(observations.pose_positions.size());
  for (const TreeNode& tree : trees) {
    std::vector<Weighted> heights;
    for (const std::size_t o : tree.observations)
      if (observations.all[o].has_height) heights.push_back({observations.all[o].position.z(), observations.all[o].weight});
    if (heights.size() < 3) continue;
    const double height = weighted_median(std::move(heights));
    for (const std::size_t o : tree.observations)
      if (observations.all[o].has_height)
        differences[observations.all[o].frame].push_back({observations.all[o].position.z() - height, observations.all[o].weight});
  }
  std::vector<double> biases;
  for (auto& d : differences) biases.push_back(weighted_median(std::move(d)));
  return biases;
}

bool believed(const TreeNode& tree, const FrameObservations& observations, const GlobalInventorySettings& settings) {
  if (tree.observations.size() >= static_cast<std::size_t>(std::max(1, settings.least_sightings))) return true;
  return std::any_of(tree.observations.begin(), tree.observations.end(), [&](std::size_t o) { return observations.all[o].reconstructed; });
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

std::string centimetres(double m) { return std::to_string(static_cast<int>(std::lround(100.0 * m))) + " cm"; }
std::string percent(double share) { return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " %"; }

std::vector<FrameDoubt> list_doubts(const FrameSet& frames, const std::vector<FrameConsistency>& judged) {
  std::vector<FrameDoubt> doubts;
  for (const FrameConsistency& j : judged) {
    if (!j.contradicts) continue;
    FrameDoubt doubt{frames.frames[j.frame].number, j.displacement.norm(), j.agreement, j.weight, {}};
    doubt.text = "Frame " + std::to_string(doubt.number) + " contradicts the trajectory: its stems lie " + centimetres(doubt.displacement_m) +
                 " off those of its neighbours, " + percent(doubt.agreement) + " of them are seen by others; " +
                 (doubt.weight > 0.0 ? "it counts " + percent(doubt.weight) + "." : "it moves no tree.");
    doubts.push_back(doubt);
  }
  return doubts;
}

void report_observations(const FrameObservations& observations, const std::vector<TreeNode>& trees, GlobalInventoryReport& report) {
  report.observations = static_cast<int>(observations.all.size());
  report.tilt_deg = degrees(std::acos(std::clamp(observations.level_from_survey.rotation(2, 2), -1.0, 1.0)));
  std::vector<double> residuals;
  std::size_t used = 0;
  for (const TreeNode& tree : trees) {
    used += tree.observations.size();
    for (const std::size_t o : tree.observations)
      if (observations.all[o].reconstructed && tree.observations.size() >= 3)
        residuals.push_back((observations.all[o].plane() - tree.position).norm());
  }
  for (const Observation& o : observations.all) report.reconstructed_observations += o.reconstructed ? 1 : 0;
  report.left_out = static_cast<int>(observations.all.size() - used);
  report.position_residual_m = percentile(std::move(residuals), 0.5);
}

void report_stems(const std::vector<Stem>& stems, GlobalInventoryReport& report) {
  report.stems = static_cast<int>(stems.size());
  for (const Stem& stem : stems) report.well_observed += stem.reconstructed && stem.times_seen >= 3 ? 1 : 0;
  report.notes.push_back(std::to_string(report.stems) + " stems from " + std::to_string(report.frames) + " frames; " +
                         std::to_string(report.well_observed) + " reconstructed and seen in three frames or more; repeated sightings agree to " +
                         centimetres(report.position_residual_m) + " (median).");
  if (!report.down_weighted.empty())
    report.notes.push_back(std::to_string(report.down_weighted.size()) + " frames contradict the trajectory and count less.");
  if (report.height_bias_p95_m > 0.1)
    report.notes.push_back("Base heights of single frames are off by up to " + centimetres(report.height_bias_p95_m) + " (95 of 100 frames).");
}

}  // namespace

Fields GlobalInventorySettings::fields() {
  return {{"global.association_radius_m", "m", "Stems of different frames within this may be one tree.", &association_radius_m},
          {"global.merge_radius_m", "m", "Trees nearer than this that are hardly ever seen side by side are one.", &merge_radius_m},
          {"global.position_noise_m", "m", "Scale beyond which a sighting counts less for the position.", &position_noise_m},
          {"global.search_radius_m", "m", "How far a frame may be displaced and still be recognised.", &search_radius_m},
          {"global.displaced_m", "m", "A frame displaced by more than this moves no tree.", &displaced_m},
          {"global.doubtful_m", "m", "A frame displaced by more than this is listed.", &doubtful_m},
          {"global.height_bias_m", "m", "Frames whose base heights are off by this much count half for heights.", &height_bias_m},
          {"global.least_sightings", "", "Frames that must see a tree that was never reconstructed.", &least_sightings}};
}

GlobalInventory build_global_inventory(const FrameSet& frames, const GlobalInventorySettings& usual, const Progress& progress) {
  GlobalInventory result;
  result.report.frames = static_cast<int>(frames.frames.size());
  progress.at(0.0, "Gathering the stems of all frames");
  FrameObservations observations = gather_observations(frames);
  const GlobalInventorySettings settings = fitted_to_noise(usual, observations);
  progress.at(0.1, "Checking frames against each other");
  const std::vector<FrameConsistency> judged = check_frames(observations, settings);
  put_back(judged, settings, observations);
  progress.at(0.4, "Joining sightings to trees");
  std::vector<double> weight, height_weight;
  for (const FrameConsistency& j : judged) weight.push_back(j.weight);
  std::vector<TreeNode> trees = associate_observations(observations, weight, associate_settings(settings, false));
  std::erase_if(trees, [&](const TreeNode& tree) { return !believed(tree, observations, settings); });
  progress.at(0.9, "Summarising trees");
  std::vector<double> biases = height_biases(observations, trees);
  for (double& bias : biases) height_weight.push_back(1.0 / (1.0 + std::pow(bias / settings.height_bias_m, 2))), bias = std::abs(bias);
  const SummaryContext context{frames, observations, weight, height_weight};
  for (const TreeNode& tree : trees) {
    result.stems.push_back(summarise_tree(tree, context));
    result.stems.back().source_id = "g" + std::to_string(result.stems.size());
    std::vector<FrameSighting>& sightings = result.sightings.emplace_back();
    for (const std::size_t o : tree.observations)
      sightings.push_back({frames.frames[observations.all[o].frame].number, static_cast<std::int64_t>(observations.all[o].stem)});
  }
  result.report.down_weighted = list_doubts(frames, judged);
  result.report.height_bias_p95_m = percentile(std::move(biases), 0.95);
  report_observations(observations, trees, result.report);
  report_stems(result.stems, result.report);
  return result;
}

Inventory with_global_stems(Inventory inventory, const GlobalInventorySettings& settings, const Progress& progress) {
  if (!inventory.frames || !inventory.stems.empty()) return inventory;
  GlobalInventory global = build_global_inventory(*inventory.frames, settings, progress);
  inventory.stems = std::move(global.stems);
  for (const std::string& note : global.report.notes) inventory.source.notes.push_back(note);
  constexpr std::size_t most_listed = 20;
  const auto& doubts = global.report.down_weighted;
  for (std::size_t i = 0; i < std::min(most_listed, doubts.size()); ++i) inventory.source.notes.push_back(doubts[i].text);
  if (doubts.size() > most_listed) inventory.source.notes.push_back("... and " + std::to_string(doubts.size() - most_listed) + " frames more.");
  return inventory;
}

}  // namespace stemwise
