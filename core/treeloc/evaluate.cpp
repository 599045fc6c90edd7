#include "core/treeloc/evaluate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/treeloc/align_truths.hpp"
#include "core/treeloc/pose_covariance.hpp"

namespace stemwise::treeloc {
namespace {

constexpr double nothing_within_m = 30.0;

double planar_distance_m(const Scene& a, const Scene& b) {
  return (a.survey_from_scene.translation_m - b.survey_from_scene.translation_m).head<2>().norm();
}

/// Planar distance from the query to the nearest of the first `limit` scenes of the map.
double nearest_m(const Scene& query, std::span<const Scene> map, std::uint32_t limit) {
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t s = 0; s < std::min<std::size_t>(limit, map.size()); ++s)
    nearest = std::min(nearest, planar_distance_m(query, map[s]));
  return nearest;
}

QueryRow row_of(const Scene& query, const Localization& found, std::span<const Scene> map, const EvaluateSettings& protocol) {
  QueryRow row;
  row.query = query.number;
  row.true_survey_from_query = query.survey_from_scene;
  if (found.candidates.empty()) return row;
  const Candidate& best = found.candidates.front();
  const Scene& scene = map[best.scene];
  row.candidate = scene.number;
  row.score = best.score;
  row.pairs = best.pairs;
  row.votes = best.votes;
  row.candidate_distance_m = planar_distance_m(query, scene);
  row.positive = row.candidate_distance_m <= protocol.positive_m;
  row.runner_up_score = found.candidates.size() > 1 ? found.candidates[1].score : 0.0;
  row.candidate_from_query = best.candidate_from_query;
  row.survey_from_query = scene.survey_from_scene * best.candidate_from_query;
  row.covariance = found.covariance;
  compare_with_truth(row, scene.survey_from_scene.inverse() * query.survey_from_scene);
  return row;
}

EvaluationTiming timing_of(std::span<const Localization> found) {
  EvaluationTiming t;
  std::vector<double> query_ms;
  for (const Localization& f : found) {
    t.describe_ms_per_scene += 1e3 * f.describe_s;
    t.retrieve_ms_per_query += 1e3 * f.retrieve_s;
    t.verify_ms_per_query += 1e3 * f.verify_s;
    query_ms.push_back(1e3 * (f.retrieve_s + f.verify_s));
  }
  if (query_ms.empty()) return t;
  const double n = static_cast<double>(query_ms.size());
  t.describe_ms_per_scene /= n;
  t.retrieve_ms_per_query /= n;
  t.verify_ms_per_query /= n;
  t.query_ms_mean = t.retrieve_ms_per_query + t.verify_ms_per_query;
  std::sort(query_ms.begin(), query_ms.end());
  t.query_ms_p99 = query_ms[static_cast<std::size_t>(std::ceil(0.99 * n)) - 1];
  return t;
}

/// The queries that count: those with a positive among their candidates. The others tell how high a score chance reaches.
struct Selection {
  std::vector<Scene> queries;
  std::vector<std::uint32_t> limits;
  std::vector<double> nearest_m;
};

Evaluation measure(const Localizer& localizer, const Selection& selection, const Settings& settings,
                   const EvaluateSettings& protocol, int threads, const Progress& progress) {
  Evaluation e;
  e.acceptance_score = acceptance_score(settings.method);
  e.map_scenes = localizer.scenes().size();
  const auto found = localize_all(localizer, selection.queries, selection.limits, threads, progress);
  std::vector<Localization> timed;
  for (std::size_t q = 0; q < found.size(); ++q) {
    QueryRow row = row_of(selection.queries[q], found[q], localizer.scenes(), protocol);
    row.nearest_m = selection.nearest_m[q];
    row.query_s = found[q].retrieve_s + found[q].verify_s;
    const bool has_positive = row.nearest_m <= protocol.positive_m;
    e.tilt_observed += has_positive && selection.queries[q].tilt_observed ? 1.0 : 0.0;
    (has_positive ? e.rows : e.others).push_back(std::move(row));
    if (has_positive) timed.push_back(found[q]);
  }
  e.tilt_observed /= std::max<double>(1.0, static_cast<double>(e.rows.size()));
  e.retrieval = retrieval_metrics(e.rows, protocol.thresholds);
  e.pose_2d = pose_metrics(e.rows, protocol, false);
  e.pose_3d = pose_metrics(e.rows, protocol, true);
  e.timing = timing_of(timed);
  return e;
}

/// Keeps queries with a positive, and the others where they are wanted.
void select(Selection& selection, const Scene& query, std::span<const Scene> map, std::uint32_t limit,
            const EvaluateSettings& protocol) {
  const double nearest = nearest_m(query, map, limit);
  if (limit == 0 || (nearest > protocol.positive_m && !protocol.with_negatives)) return;
  selection.queries.push_back(query);
  selection.limits.push_back(limit);
  selection.nearest_m.push_back(nearest);
}

/// Rows and others with the errors that count.
void count_accepted(Evaluation& e, std::span<const QueryRow> rows, std::span<const QueryRow> others) {
  constexpr double wrong_m = 1.0;
  for (const auto& part : {rows, others})
    for (const QueryRow& row : part) {
      const bool accepted = row.found() && row.score >= e.acceptance_score;
      if (row.nearest_m > nothing_within_m) {
        ++e.queries_without_truth;
        e.accepted_without_truth += accepted ? 1 : 0;
        e.highest_score_without_truth = std::max(e.highest_score_without_truth, row.score);
        continue;
      }
      ++e.queries_within_30_m;
      e.accepted += accepted ? 1 : 0;
      e.accepted_wrong += accepted && row.error.planar_m() > wrong_m ? 1 : 0;
      e.accepted_wrong_in_space += accepted && row.error.spatial_m() > wrong_m ? 1 : 0;
    }
}

double timed_add(Localizer& localizer, DescribedScenes scenes, int threads) {
  const auto start = std::chrono::steady_clock::now();
  localizer.add(std::move(scenes), threads);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Fields EvaluateSettings::fields(const std::string& prefix) {
  return {{prefix + ".excluded_preceding", "", "Preceding frames that are no candidates of a frame of the same survey",
           &excluded_preceding},
          {prefix + ".positive_m", "m", "A candidate truly within this planar distance is a positive", &positive_m},
          {prefix + ".pose_limit_m", "m", "Position error of a successful pose", &pose_limit_m},
          {prefix + ".pose_limit_deg", "deg", "Rotation error of a successful pose", &pose_limit_deg},
          {prefix + ".thresholds", "", "Score thresholds of the precision-recall sweep", &thresholds},
          {prefix + ".height_between_surveys_m", "m", "How much the carried sensors of two surveys differ in height",
           &height_between_surveys_m},
          {prefix + ".with_negatives", "", "Ask for queries without a positive too", &with_negatives}};
}

Issues EvaluateSettings::check() const {
  Issues issues;
  const auto refuse = [&](const char* key, const char* expected) { issues.push_back({Severity::error, "", 0, "", std::string("protocol.") + key + ": expected " + expected, ""}); };
  if (!(positive_m > 0.0)) refuse("positive_m", "a distance above 0 m");
  if (!(pose_limit_m > 0.0)) refuse("pose_limit_m", "a distance above 0 m");
  if (!(pose_limit_deg > 0.0)) refuse("pose_limit_deg", "an angle above 0 degrees");
  if (thresholds < 2) refuse("thresholds", "2 or more");
  if (excluded_preceding < 0) refuse("excluded_preceding", "0 or more");
  return issues;
}

double PoseError::planar_m() const { return std::hypot(position_m[0], position_m[1]); }
double PoseError::spatial_m() const { return std::hypot(position_m[0], position_m[1], position_m[2]); }
double PoseError::rotation_deg() const { return std::hypot(angle_deg[0], angle_deg[1], angle_deg[2]); }

PoseError pose_error(const RigidTransform& estimate, const RigidTransform& truth) {
  PoseError e;
  const Eigen::Vector3d d = estimate.translation_m - truth.translation_m;
  const RollPitchYaw angles = roll_pitch_yaw(truth.rotation.transpose() * estimate.rotation);
  e.position_m = {d.x(), d.y(), d.z()};
  e.angle_deg = {degrees(angles.roll_rad), degrees(angles.pitch_rad), degrees(angles.yaw_rad)};
  return e;
}

void compare_with_truth(QueryRow& row, const RigidTransform& true_candidate_from_query) {
  row.true_candidate_from_query = true_candidate_from_query;
  row.error = pose_error(row.candidate_from_query, true_candidate_from_query);
  row.mahalanobis_sq = mahalanobis_sq(row.candidate_from_query, row.covariance, true_candidate_from_query);
}

bool is_success(const QueryRow& row, const EvaluateSettings& protocol, bool spatial) {
  const double distance_m = spatial ? row.error.spatial_m() : row.error.planar_m();
  const double angle_deg = spatial ? row.error.rotation_deg() : std::abs(row.error.angle_deg[2]);
  return row.found() && distance_m <= protocol.pose_limit_m && angle_deg <= protocol.pose_limit_deg;
}

PoseMetrics pose_metrics(std::span<const QueryRow> rows, const EvaluateSettings& protocol, bool spatial) {
  PoseMetrics m;
  double successes = 0.0;
  for (const QueryRow& row : rows) {
    if (!is_success(row, protocol, spatial)) continue;
    m.r50 += 1.0;
    if (!row.positive) continue;
    successes += 1.0;
    m.ate_m += spatial ? row.error.spatial_m() : row.error.planar_m();
    m.are_deg += spatial ? row.error.rotation_deg() : std::abs(row.error.angle_deg[2]);
  }
  const double n = std::max<double>(1.0, static_cast<double>(rows.size()));
  m.r50 /= n;
  m.sr = successes / n;
  if (successes > 0.0) m.ate_m /= successes, m.are_deg /= successes;
  return m;
}

RetrievalMetrics retrieval_metrics(std::span<const QueryRow> rows, int thresholds) {
  RetrievalMetrics m;
  double positives = 0.0;
  for (const QueryRow& row : rows) positives += row.positive ? 1.0 : 0.0;
  if (rows.empty() || positives == 0.0) return m;
  m.recall_at_1 = positives / static_cast<double>(rows.size());
  double last_recall = 0.0, last_precision = 1.0;
  for (int k = thresholds - 1; k >= 0; --k) {
    const double threshold = static_cast<double>(k) / (thresholds - 1);
    double true_positive = 0.0, false_positive = 0.0;
    for (const QueryRow& row : rows) {
      if (row.found() && row.score >= threshold) (row.positive ? true_positive : false_positive) += 1.0;
    }
    if (true_positive + false_positive == 0.0) continue;
    const double precision = true_positive / (true_positive + false_positive);
    const double recall = true_positive / positives;
    if (false_positive == 0.0) m.mr = std::max(m.mr, recall);
    if (true_positive > 0.0) m.mf1 = std::max(m.mf1, 2.0 * precision * recall / (precision + recall));
    m.auc += 0.5 * (precision + last_precision) * (recall - last_recall);
    last_recall = recall;
    last_precision = precision;
  }
  return m;
}

Evaluation evaluate_intra(DescribedScenes described, const Settings& settings, const EvaluateSettings& protocol, int threads,
                          const Progress& progress) {
  Selection selection;
  const std::vector<Scene>& scenes = described.scenes;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto excluded = static_cast<std::size_t>(protocol.excluded_preceding);
    select(selection, scenes[i], scenes, static_cast<std::uint32_t>(i > excluded ? i - excluded : 0), protocol);
  }
  const auto localizer = make_localizer(settings);
  const double index_s = timed_add(*localizer, std::move(described), threads);
  Evaluation e = measure(*localizer, selection, settings, protocol, threads, progress);
  e.timing.index_s = index_s;
  count_accepted(e, e.rows, e.others);
  e.calibration = calibration_of(e.rows);
  return e;
}

Evaluation evaluate_inter(std::vector<Scene> queries, DescribedScenes map, std::span<const Polygon> regions,
                          const Settings& settings, const EvaluateSettings& protocol, int threads, const Progress& progress) {
  Selection selection;
  for (const Scene& query : queries) {
    const Eigen::Vector2d at = query.survey_from_scene.translation_m.head<2>();
    const bool counts =
        regions.empty() || std::any_of(regions.begin(), regions.end(), [&](const Polygon& r) { return contains(r, at); });
    if (counts) select(selection, query, map.scenes, QueryWorker::all_scenes, protocol);
  }
  queries.clear();
  queries.shrink_to_fit();
  Settings between = settings;
  between.refine.height_prior_m = std::hypot(settings.refine.height_prior_m, protocol.height_between_surveys_m);
  const auto localizer = make_localizer(between);
  const double index_s = timed_add(*localizer, std::move(map), threads);
  Evaluation e = measure(*localizer, selection, settings, protocol, threads, progress);
  e.timing.index_s = index_s;
  std::vector<QueryRow> aligned = e.rows, others = e.others;
  const RigidTransform map_from_query_survey = align_truths(aligned);
  compare_with_moved_truth(others, map_from_query_survey);
  count_accepted(e, aligned, others);
  e.pose_3d_truth_aligned = pose_metrics(aligned, protocol, true);
  e.calibration = calibration_of(aligned);
  e.truth_aligned_rows = std::move(aligned);
  return e;
}

}  // namespace stemwise::treeloc
