#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/polygon.hpp"
#include "core/jobs/progress.hpp"
#include "core/treeloc/localizer.hpp"

namespace stemwise::treeloc {

/// The paper's protocol (method.md, section 10).
struct EvaluateSettings {
  int excluded_preceding = 50;  ///< intra: candidates of frame i are the frames 0 to i - 51
  double positive_m = 5.0;
  double pose_limit_m = 0.5;
  double pose_limit_deg = 5.0;
  int thresholds = 1000;
  double height_between_surveys_m = 0.3;  ///< inter: how much the carried sensors of two surveys differ in height
  bool with_negatives = true;  ///< ask for queries without a positive too, to see what the threshold accepts
  Fields fields(const std::string& prefix);
  Issues check() const;
};

/// A pose against the truth: differences of x, y, z (m), roll, pitch, yaw (degrees) of candidate-from-query.
struct PoseError {
  std::array<double, 3> position_m{};
  std::array<double, 3> angle_deg{};
  double planar_m() const;
  double spatial_m() const;
  double rotation_deg() const;  ///< norm of the three angles
};
PoseError pose_error(const RigidTransform& estimate, const RigidTransform& truth);

/// One query and what was found for it.
struct QueryRow {
  std::int64_t query = 0;
  std::int64_t candidate = -1;  ///< frame number; -1: nothing was found
  bool positive = false;
  double score = 0.0;
  int pairs = 0;
  int votes = 0;
  double candidate_distance_m = 0.0;  ///< true planar distance of the candidate
  double nearest_m = 0.0;             ///< true planar distance of the nearest scene that was a candidate
  double runner_up_score = 0.0;
  double query_s = 0.0;  ///< retrieval to pose
  PoseError error;
  RigidTransform candidate_from_query;
  PoseCovariance covariance = PoseCovariance::Zero();  ///< of candidate_from_query
  double mahalanobis_sq = 0.0;                         ///< of the truth, by it
  RigidTransform true_candidate_from_query;
  RigidTransform survey_from_query;  ///< estimate, in the database's frame
  RigidTransform true_survey_from_query;
  bool found() const { return candidate >= 0; }
};

struct PoseMetrics {
  double r50 = 0.0, sr = 0.0, ate_m = 0.0, are_deg = 0.0;
};

struct RetrievalMetrics {
  double recall_at_1 = 0.0, mr = 0.0, mf1 = 0.0, auc = 0.0;
};

/// Do the covariances tell the truth? Over all poses that were found for queries with a positive, wrong places too.
struct Calibration {
  int poses = 0;
  double inside_95 = 0.0;           ///< share of truths inside the 95 % region of all six degrees of freedom
  double inside_95_position = 0.0;  ///< of x, y, z alone
  double inside_95_rotation = 0.0;  ///< of the rotation alone
  double median_position_sd_m = 0.0;    ///< square root of the trace
  double median_rotation_sd_deg = 0.0;
};

struct EvaluationTiming {
  double describe_ms_per_scene = 0.0, retrieve_ms_per_query = 0.0, verify_ms_per_query = 0.0, query_ms_mean = 0.0,
         query_ms_p99 = 0.0;
  double index_s = 0.0;
};

struct Evaluation {
  std::vector<QueryRow> rows;    ///< of queries with a positive: what is measured
  std::vector<QueryRow> others;  ///< of queries without one; those with a scene within 30 m may be localised nevertheless
  std::vector<QueryRow> truth_aligned_rows;  ///< inter: the same with errors after one SE(3) was fitted between the truths
  std::size_t map_scenes = 0;
  RetrievalMetrics retrieval;
  PoseMetrics pose_2d, pose_3d;
  std::optional<PoseMetrics> pose_3d_truth_aligned;  ///< inter: after one SE(3) was fitted between the truths
  Calibration calibration;                           ///< inter: after that fit
  double tilt_observed = 0.0;  ///< share of the measured queries with stem axes: of the others roll and pitch are not observed
  EvaluationTiming timing;
  /// What the method's fixed threshold accepts of all queries with a scene within 30 m, a positive or not. `wrong`: more than 1 m
  /// from the truth in the plane, or in space (the truth moved by the fitted SE(3) between sessions).
  double acceptance_score = 0.0;
  int queries_within_30_m = 0;
  int accepted = 0;
  int accepted_wrong = 0;
  int accepted_wrong_in_space = 0;
  /// Queries without anything within 30 m: the highest score of any is what a threshold must exceed.
  int queries_without_truth = 0;
  int accepted_without_truth = 0;
  double highest_score_without_truth = 0.0;
};

/// Query and database are the frames of one survey in driving order.
Evaluation evaluate_intra(DescribedScenes scenes, const Settings& settings, const EvaluateSettings& protocol, int threads,
                          const Progress& progress);
/// Only query frames inside one of `regions` count (all when there are none).
Evaluation evaluate_inter(std::vector<Scene> queries, DescribedScenes map, std::span<const Polygon> regions,
                          const Settings& settings, const EvaluateSettings& protocol, int threads, const Progress& progress);

/// Of rows whose `error` and `mahalanobis_sq` are against the truth that counts.
Calibration calibration_of(std::span<const QueryRow> rows);
/// Fills in `error` and `mahalanobis_sq` against a truth.
void compare_with_truth(QueryRow& row, const RigidTransform& true_candidate_from_query);

/// Is the pose within the protocol's limits, in the plane or in space? (R@50; with a positive candidate: SR.)
bool is_success(const QueryRow& row, const EvaluateSettings& protocol, bool spatial);
PoseMetrics pose_metrics(std::span<const QueryRow> rows, const EvaluateSettings& protocol, bool spatial);
RetrievalMetrics retrieval_metrics(std::span<const QueryRow> rows, int thresholds);

}  // namespace stemwise::treeloc
