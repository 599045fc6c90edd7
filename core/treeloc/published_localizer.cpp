#include "core/treeloc/published_localizer.hpp"

#include <algorithm>
#include <chrono>

#include "core/base/parallel.hpp"
#include "core/treeloc/correct_vertical.hpp"
#include "core/treeloc/estimate_planar_pose.hpp"
#include "core/treeloc/estimate_roll_pitch.hpp"
#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/overlap_score.hpp"
#include "core/treeloc/pose_covariance.hpp"
#include "core/treeloc/reject_outliers.hpp"
#include "core/treeloc/retrieve_scenes.hpp"

namespace stemwise::treeloc {
namespace {

using Clock = std::chrono::steady_clock;
double seconds(Clock::time_point from, Clock::time_point to) { return std::chrono::duration<double>(to - from).count(); }

struct Database {
  Settings settings;
  std::vector<Scene> scenes;
  std::vector<PublishedDescriptor> descriptors;
  PlanarTreeStore trees;
};

class PublishedWorker final : public QueryWorker {
public:
  explicit PublishedWorker(const Database& database)
      : db_(database), maker_(database.settings.triangles), matcher_({.tau_dbh_m = database.settings.match.tau_dbh_m}) {}

  Localization localize(const Scene& query, std::uint32_t scene_limit) override {
    const Settings& s = db_.settings;
    const auto start = Clock::now();
    const PublishedDescriptor descriptor = describe_published(query, s.tdh, s.pdh, maker_);
    const auto described = Clock::now();
    const auto retrieved = retrieve_scenes(descriptor, db_.descriptors, scene_limit, s.tdh.enabled, s.pdh.enabled, s.retrieve);
    const auto verifying = Clock::now();
    query_trees_.clear();
    query_trees_.add(query);
    Localization found;
    for (const RetrievedScene& r : retrieved) {
      if (auto candidate = verify(query, descriptor, r)) found.candidates.push_back(std::move(*candidate));
    }
    std::stable_sort(found.candidates.begin(), found.candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    if (!found.candidates.empty()) found.covariance = covariance_of(query, found.candidates.front());
    found.triangles = static_cast<int>(descriptor.triangles.size());
    found.describe_s = seconds(start, described);
    found.retrieve_s = seconds(described, verifying);
    found.verify_s = seconds(verifying, Clock::now());
    return found;
  }

private:
  /// Sections 6 to 8 for one candidate.
  std::optional<Candidate> verify(const Scene& query, const PublishedDescriptor& descriptor, const RetrievedScene& retrieved) {
    const Settings& s = db_.settings;
    const Scene& scene = db_.scenes[retrieved.scene];
    const auto& triangles = db_.descriptors[retrieved.scene].triangles;
    const auto matches = match_triangles(descriptor.triangles, triangles, query, scene, s.outliers);
    const auto inliers = vote_yaw(matches, descriptor.triangles, triangles, query, scene, s.outliers);
    if (inliers.empty()) return std::nullopt;
    PlanarPose pose = estimate_planar_pose(inliers, descriptor.triangles, triangles, query, scene, s.planar);
    const PlanarTrees in_query = query_trees_.trees(0), in_scene = db_.trees.trees(retrieved.scene);
    matcher_.pair(in_query, in_scene, pose, s.match.fine_m);  // eq. 10
    if (s.planar.irls && matcher_.pairs().size() >= 3) pose = solve_pairs(query, scene, pose);
    Candidate c;
    c.scene = retrieved.scene;
    c.votes = retrieved.shared;
    c.pairs = static_cast<int>(matcher_.pairs().size());
    c.displacement_m = pose.displacement_m();
    c.score = overlap_score(c.pairs, query.trees.size(), scene.trees.size(), c.displacement_m, s.overlap);
    c.candidate_from_query = six_dof(query, scene, pose, retrieved.scene);
    return c;
  }

  /// Not published: what the residuals of the paired trees say. A height prior is no part of that method.
  PoseCovariance covariance_of(const Scene& query, const Candidate& best) {
    const Scene& scene = db_.scenes[best.scene];
    const RigidTransform aligned{
        scene.aligned_from_scene * best.candidate_from_query.rotation * query.aligned_from_scene.transpose(),
        scene.aligned_from_scene * best.candidate_from_query.translation_m};
    matcher_.pair(query_trees_.trees(0), db_.trees.trees(best.scene), planar_part(aligned), db_.settings.match.fine_m);
    RefinePoseSettings residuals = db_.settings.refine;
    residuals.height_prior = false;
    const PoseCovariance alone = pair_covariance(query, scene, matcher_.pairs(), best.candidate_from_query, residuals);
    return fused_covariance(alone, scene.survey_from_scene.rotation, {}, {}, db_.settings.covariance);
  }

  /// eq. 9 once more, over the paired trees.
  PlanarPose solve_pairs(const Scene& query, const Scene& scene, const PlanarPose& pose) const {
    std::vector<PlanarPair> points;
    for (const TreePair& p : matcher_.pairs()) {
      const Eigen::Vector2d q = query.trees[p.query].position_m.head<2>(), c = scene.trees[p.candidate].position_m.head<2>();
      const double residual_m = (pose * q - c).norm();
      points.push_back({q, c, residual_m > db_.settings.planar.huber_m ? db_.settings.planar.huber_m / residual_m : 1.0});
    }
    return fit_planar_pose(points);
  }

  /// Residual roll and pitch, vertical correction, both axis alignments undone (section 7.3 to 7.5).
  RigidTransform six_dof(const Scene& query, const Scene& scene, const PlanarPose& pose, std::uint32_t number) const {
    const Settings& s = db_.settings;
    const RigidTransform tilt{estimate_roll_pitch(query, scene, matcher_.pairs(), pose, s.roll_pitch), Eigen::Vector3d::Zero()};
    const RigidTransform tilted = tilt * pose.lifted();
    const std::uint64_t seed = s.seed * 1000003 + static_cast<std::uint64_t>(query.number) * 7919 + number;
    const RigidTransform vertical = correct_vertical(query, scene, matcher_.pairs(), tilted, s.vertical, seed);
    const RigidTransform scene_upright{scene.aligned_from_scene, Eigen::Vector3d::Zero()};
    const RigidTransform query_upright{query.aligned_from_scene, Eigen::Vector3d::Zero()};
    return scene_upright.inverse() * vertical * tilted * query_upright;
  }

  const Database& db_;
  TriangleMaker maker_;
  TreeMatcher matcher_;
  PlanarTreeStore query_trees_;
};

class PublishedLocalizer final : public Localizer {
public:
  explicit PublishedLocalizer(const Settings& settings) : db_{settings, {}, {}, {}} {}
  void add(DescribedScenes described, int threads) override {
    std::vector<Scene>& scenes = described.scenes;
    constexpr std::size_t per_block = 64;
    const std::size_t first = db_.descriptors.size();
    db_.descriptors.resize(first + scenes.size());
    parallel_for((scenes.size() + per_block - 1) / per_block, threads, [&](std::size_t block) {
      TriangleMaker maker(db_.settings.triangles);
      for (std::size_t i = block * per_block; i < std::min(scenes.size(), (block + 1) * per_block); ++i) {
        db_.descriptors[first + i] = describe_published(scenes[i], db_.settings.tdh, db_.settings.pdh, maker);
      }
    });
    for (Scene& scene : scenes) {
      db_.trees.add(scene);
      db_.scenes.push_back(std::move(scene));
    }
  }
  const std::vector<Scene>& scenes() const override { return db_.scenes; }
  std::unique_ptr<QueryWorker> worker() const override { return std::make_unique<PublishedWorker>(db_); }

private:
  Database db_;
};

}  // namespace

std::unique_ptr<Localizer> make_published_localizer(const Settings& settings) {
  return std::make_unique<PublishedLocalizer>(settings);
}

}  // namespace stemwise::treeloc
