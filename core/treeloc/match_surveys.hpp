#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/forest/frame_set.hpp"
#include "core/jobs/progress.hpp"
#include "core/treeloc/localizer.hpp"
#include "core/treeloc/verify_scenes.hpp"

namespace stemwise::treeloc {

/// A scene of survey B was recognised in survey A.
struct SceneConstraint {
  std::size_t scene_a = 0;              ///< index in the scenes (frames) of A
  std::size_t scene_b = 0;              ///< index in the scenes (frames) of B
  RigidTransform a_from_b;              ///< survey A's frame from survey B's frame, as this one scene sees it
  RigidTransform scene_a_from_scene_b;  ///< the same between the two scenes: an edge of a pose graph
  bool tilt_observed = false;           ///< roll and pitch came from stem axes in both
  double score = 0.0;
  double evidence = 0.0;  ///< how far beyond chance the matched trees are (log)
  int pairs = 0;          ///< matched trees
  PoseCovariance covariance = PoseCovariance::Zero();  ///< of scene_a_from_scene_b (pose_covariance.hpp)
};

struct MatchSurveysSettings {
  int most_queries = 400;  ///< scenes of B that are looked for, evenly spread
  double accept_score = stemwise_acceptance_score;
  double min_evidence = 3.0;    ///< chance_evidence: natural log, against chance at every pose and scene tried
  double grid_spacing_m = 5.0;  ///< of scenes cut from a global list
  int grid_min_trees = 12;
  double height_between_surveys_m = 0.3;  ///< carried sensors of two surveys: how much their heights above ground may differ
  Fields fields(const std::string& prefix);
};

/// Scenes of one survey for matching: its frames, or its global list cut on a grid.
std::vector<Scene> survey_scenes(const FrameSet& frames, const Settings& method, int threads);
std::vector<Scene> survey_scenes(std::span<const Stem> stems, const Settings& method, const MatchSurveysSettings& settings,
                                 int threads);

/// Looks for the scenes of B in A (method.md, section 9) and gives the relative poses that are accepted by score, in order
/// of B's scenes. Each is right or wrong on its own: a joint robust estimate must follow. Deterministic. Throws Cancelled.
std::vector<SceneConstraint> match_surveys(std::vector<Scene> scenes_a, std::span<const Scene> scenes_b, const Settings& method,
                                           const MatchSurveysSettings& settings, int threads, const Progress& progress);

/// The usual case: both surveys have frames, default method.
std::vector<SceneConstraint> match_surveys(const FrameSet& a, const FrameSet& b, const MatchSurveysSettings& settings,
                                           int threads, const Progress& progress);

}  // namespace stemwise::treeloc
