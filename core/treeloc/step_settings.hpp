#pragma once
#include <string>

#include "core/base/field.hpp"

/// The settings of every step, plain values apart from the steps themselves: who only passes them on needs no algorithm.
/// Each step's own header says what it does; `fields` gives its keys, units and sentences (one per step, in its source).
namespace stemwise::treeloc {

/// When a survey counts as carried at a constant height above the ground (method.md, section 12): only then may a pose be
/// told that two frames at one spot have the same height.
struct SensorHeightSettings {
  double highest_m = 4.0;
  double most_spread_m = 0.75;
  int least_frames = 10;
  Fields fields(const std::string& prefix);
};

/// Which trees make a scene (method.md, section 2).
struct PrepareSettings {
  double local_radius_m = 30.0;
  int min_reconstructed = 0;
  int preceding_frames = 5;
  double search_radius_m = 10.0;
  double dedup_radius_m = 0.1;
  int target_tree_count = 30;
  SensorHeightSettings sensor;
  Fields fields(const std::string& prefix);
};

/// How the dominant stem axis is found (method.md, section 3).
struct AlignAxesSettings {
  bool enabled = true;
  int min_clusters = 1;
  int min_trees = 3;
  double robust_scale_deg = 4.0;
  int refinements = 5;
  Fields fields(const std::string& prefix);
};

/// The triangles of a scene (method.md, section 4): every tree with each pair of its nearest neighbours.
struct TriangleSettings {
  int neighbours = 12;
  double min_side_m = 0.5;
  double max_side_m = 30.0;
  double step_m = 0.15;
  bool area = false;        ///< the published key of eq. 3 with the area
  bool orientation = true;  ///< the triangle's handedness belongs to the key
  Fields fields(const std::string& prefix);
};

/// How the triangles of a query vote for scenes and yaw angles (method.md, section 12).
struct VoteSettings {
  double tau_dbh_m = 0.15;
  double gate_m = 7.0;
  int verified = 20;
  Fields fields(const std::string& prefix);
};

/// Pairing of the trees of two scenes, coarse to fine (method.md, sections 7.2 and 12).
struct MatchTreesSettings {
  double coarse_m = 1.0;
  double fine_m = 0.4;
  int steps = 3;
  double tau_dbh_m = 0.2;
  Fields fields(const std::string& prefix);
};

/// How verified scenes are scored and chosen (method.md, sections 8 and 12).
struct VerifySettings {
  double strong_share = 0.7;
  double propagate_radius_m = 6.0;
  int propagate_most = 24;
  double penalty_m = 5.0;
  int min_pairs = 3;
  Fields fields(const std::string& prefix);
};

/// The pose of a verified candidate in all six degrees of freedom (method.md, section 12, "Poses").
struct RefinePoseSettings {
  double planar_scale_m = 0.12;
  double height_scale_m = 0.25;
  double few_clusters_share = 0.1;
  double axis_scale_deg = 0.5;
  double tilt_prior_deg = 1.0;
  bool height_prior = true;
  double height_prior_m = 0.08;
  double height_prior_per_m = 0.04;
  double height_bias_m = 0.3;
  int iterations = 6;
  Fields fields(const std::string& prefix);
};

/// Putting the poses together that several verified scenes give (method.md, section 12).
struct FusePosesSettings {
  bool enabled = true;
  int most = 20;
  double position_scale_m = 0.3;
  double rotation_scale_deg = 1.0;
  Fields fields(const std::string& prefix);
};

/// What residuals cannot show (method.md, section 12).
struct CovarianceSettings {
  double position_floor_m = 0.025;
  double tilt_floor_deg = 0.22;
  double yaw_floor_deg = 0.08;
  double shared_share = 0.5;
  double scenes_per_independent = 4.0;
  double inflation = 1.0;
  Fields fields(const std::string& prefix);
};

/// TDH (method.md, section 4): how many trees lie at which distance from the origin with which diameter.
struct TdhSettings {
  bool enabled = true;
  int radial_bins = 5;
  double radial_width_m = 6.0;
  double radial_overlap_m = 1.0;
  int dbh_bins = 8;
  double dbh_step_m = 0.1;
  double dbh_width_m = 0.15;
  bool count_once = true;  ///< a tree in two overlapping bins counts in the first one only
  Fields fields(const std::string& prefix);
};

/// PDH (method.md, section 4): distances between the reconstructed trees, whatever the origin.
struct PdhSettings {
  bool enabled = true;
  double longest_m = 10.0;
  int bins = 40;
  Fields fields(const std::string& prefix);
};

/// The published coarse-to-fine retrieval (method.md, section 5).
struct RetrieveSettings {
  bool histograms = true;
  int kept_by_histograms = 100;
  int verified = 10;
  bool multiset = true;
  Fields fields(const std::string& prefix);
};

/// Which triangle matches count (method.md, section 6).
struct RejectOutliersSettings {
  bool dbh_filter = true;
  double tau_dbh_m = 0.2;
  bool yaw_voting = true;
  double yaw_bin_deg = 5.0;
  double tau_yaw_deg = 10.0;
  Fields fields(const std::string& prefix);
};

/// SE(2) from inlier triangles (method.md, section 7.1).
struct EstimatePlanarPoseSettings {
  bool irls = true;
  double huber_m = 0.4;
  int iterations = 10;
  Fields fields(const std::string& prefix);
};

/// Residual roll and pitch from the axes of paired trees, yaw fixed (method.md, section 7.3).
struct EstimateRollPitchSettings {
  bool enabled = true;
  double inlier_deg = 2.5;
  double least_share = 0.5;
  int least_inliers = 5;
  Fields fields(const std::string& prefix);
};

/// Joint vertical correction (method.md, section 7.4): z' ~ z - psi x + phi y.
struct CorrectVerticalSettings {
  bool joint = true;
  double inlier_m = 0.1;
  int sample = 4;
  int trials = 100;
  int least_inliers = 3;
  Fields fields(const std::string& prefix);
};

/// The published overlap score (method.md, section 8).
struct OverlapScoreSettings {
  bool penalty = true;
  double sigma_t_m = 5.0;
  Fields fields(const std::string& prefix);
};

}  // namespace stemwise::treeloc
