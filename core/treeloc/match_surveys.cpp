#include "core/treeloc/match_surveys.hpp"

#include <algorithm>
#include <cmath>

#include "core/treeloc/prepare_scene.hpp"

namespace stemwise::treeloc {
namespace {

/// Indices of `count` items, thinned evenly to at most `most`.
std::vector<std::size_t> spread(std::size_t count, int most) {
  const std::size_t wanted = std::min(count, static_cast<std::size_t>(std::max(1, most)));
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < wanted; ++i) chosen.push_back(i * count / wanted);
  return chosen;
}

}  // namespace

Fields MatchSurveysSettings::fields(const std::string& prefix) {
  return {{prefix + ".most_queries", "", "Scenes of one survey that are looked for in the other, evenly spread", &most_queries},
          {prefix + ".accept_score", "", "Overlap score from which on a scene counts as recognised", &accept_score},
          {prefix + ".min_evidence", "", "How far beyond chance its matched trees must be (log)", &min_evidence},
          {prefix + ".grid_spacing_m", "m", "Spacing of the scenes that are cut from a global list", &grid_spacing_m},
          {prefix + ".grid_min_trees", "", "Trees that such a scene needs", &grid_min_trees},
          {prefix + ".height_between_surveys_m", "m", "How much carried sensors of two surveys differ in height",
           &height_between_surveys_m}};
}

std::vector<Scene> survey_scenes(const FrameSet& frames, const Settings& method, int threads) {
  return prepare_frame_scenes(frames, method.scene, method.axes, threads);
}

std::vector<Scene> survey_scenes(std::span<const Stem> stems, const Settings& method, const MatchSurveysSettings& settings,
                                 int threads) {
  return prepare_grid_scenes(stems, settings.grid_spacing_m, settings.grid_min_trees, method.scene, method.axes, threads);
}

std::vector<SceneConstraint> match_surveys(std::vector<Scene> scenes_a, std::span<const Scene> scenes_b, const Settings& method,
                                           const MatchSurveysSettings& settings, int threads, const Progress& progress) {
  if (scenes_a.empty() || scenes_b.empty()) return {};
  Settings between = method;
  between.refine.height_prior_m = std::hypot(method.refine.height_prior_m, settings.height_between_surveys_m);
  const auto localizer = make_localizer(between);
  localizer->add(std::move(scenes_a), threads);
  progress.at(0.2, "Describing scenes");
  const auto chosen = spread(scenes_b.size(), settings.most_queries);
  std::vector<Scene> queries;
  for (const std::size_t i : chosen) queries.push_back(scenes_b[i]);
  const auto found = localize_all(*localizer, queries, {}, threads, progress.stage(0.2, 1.0));
  std::vector<SceneConstraint> constraints;
  for (std::size_t q = 0; q < queries.size(); ++q) {
    if (found[q].candidates.empty()) continue;
    const Candidate& best = found[q].candidates.front();
    if (best.score < settings.accept_score || best.evidence < settings.min_evidence) continue;
    const Scene& in_a = localizer->scenes()[best.scene];
    constraints.push_back(
        {best.scene, chosen[q], in_a.survey_from_scene * best.candidate_from_query * queries[q].survey_from_scene.inverse(),
         best.candidate_from_query, in_a.tilt_observed && queries[q].tilt_observed, best.score, best.evidence, best.pairs,
         found[q].covariance});
  }
  return constraints;
}

std::vector<SceneConstraint> match_surveys(const FrameSet& a, const FrameSet& b, const MatchSurveysSettings& settings,
                                           int threads, const Progress& progress) {
  const Settings method = settings_for(Method::stemwise, "auto");
  return match_surveys(survey_scenes(a, method, threads), survey_scenes(b, method, threads), method, settings, threads, progress);
}

}  // namespace stemwise::treeloc
