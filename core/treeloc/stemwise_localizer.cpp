#include "core/treeloc/stemwise_localizer.hpp"

#include <algorithm>
#include <chrono>
#include <tuple>

#include "core/treeloc/chance_evidence.hpp"
#include "core/treeloc/fuse_poses.hpp"
#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/pose_covariance.hpp"
#include "core/treeloc/refine_pose.hpp"
#include "core/treeloc/verify_scenes.hpp"
#include "core/treeloc/vote_scenes.hpp"

namespace stemwise::treeloc {
namespace {

using Clock = std::chrono::steady_clock;
double seconds(Clock::time_point from, Clock::time_point to) { return std::chrono::duration<double>(to - from).count(); }

/// Where scenes stand in their survey, in order of x.
class ScenePositions {
public:
  void update(std::span<const Scene> scenes) {
    for (std::size_t s = by_x_.size(); s < scenes.size(); ++s) {
      const Eigen::Vector3d& at = scenes[s].survey_from_scene.translation_m;
      by_x_.push_back({at.x(), at.y(), static_cast<std::uint32_t>(s)});
    }
    std::sort(by_x_.begin(), by_x_.end(),
              [](const Place& a, const Place& b) { return std::tie(a.x, a.scene) < std::tie(b.x, b.scene); });
  }
  /// Calls take(squared planar distance, scene) for the scenes nearer than `radius_m`.
  template <class Take>
  void each_near(const Eigen::Vector3d& here, double radius_m, Take take) const {
    const auto before = [&](const Place& p) { return p.x < here.x() - radius_m; };
    for (auto p = std::partition_point(by_x_.begin(), by_x_.end(), before); p != by_x_.end() && p->x <= here.x() + radius_m;
         ++p) {
      const double dx = p->x - here.x(), dy = p->y - here.y();
      if (const double distance_sq = dx * dx + dy * dy; distance_sq < radius_m * radius_m) take(distance_sq, p->scene);
    }
  }

private:
  struct Place {
    double x, y;
    std::uint32_t scene;
  };
  std::vector<Place> by_x_;
};

struct Database {
  explicit Database(const Settings& s) : settings(s), index(s.triangles) {}
  Settings settings;
  std::vector<Scene> scenes;
  PlanarTreeStore trees;
  TriangleIndex index;
  ScenePositions positions;
};

/// A verified scene before its pose is refined.
struct Verified {
  std::uint32_t scene = 0;
  int votes = 0;
  int pairs = 0;
  PlanarPose pose;
};

class StemwiseWorker final : public QueryWorker {
public:
  explicit StemwiseWorker(const Database& database)
      : db_(database), maker_(database.settings.triangles), vote_(database.settings.vote), matcher_(database.settings.match) {}

  Localization localize(const Scene& query, std::uint32_t scene_limit) override {
    const auto start = Clock::now();
    const auto& triangles = maker_.make(query);
    const auto described = Clock::now();
    const auto voted = vote_.vote(db_.index, triangles, scene_limit);
    const auto retrieved = Clock::now();
    query_trees_.clear();
    query_trees_.add(query);
    verified_.clear();
    for (const VotedScene& v : voted) verify(v.scene, v.votes, v.pose);
    propagate(scene_limit);
    Localization found = answer(query);
    found.triangles = static_cast<int>(triangles.size());
    found.describe_s = seconds(start, described);
    found.retrieve_s = seconds(described, retrieved);
    found.verify_s = seconds(retrieved, Clock::now());
    return found;
  }

private:
  void verify(std::uint32_t scene, int votes, const PlanarPose& start) {
    const PlanarPose pose = matcher_.match(query_trees_.trees(0), db_.trees.trees(scene), start);
    const int pairs = static_cast<int>(matcher_.pairs().size());
    if (pairs >= db_.settings.verify.min_pairs) verified_.push_back({scene, votes, pairs, pose});
  }

  /// Among the strong ones the nearest; -1 where nothing was verified.
  std::ptrdiff_t choose() const {
    int most = 0;
    for (const Verified& v : verified_) most = std::max(most, v.pairs);
    std::ptrdiff_t best = -1;
    for (std::size_t i = 0; i < verified_.size(); ++i) {
      if (verified_[i].pairs < db_.settings.verify.strong_share * most) continue;
      if (best < 0 || verified_[i].pose.displacement_m() < verified_[static_cast<std::size_t>(best)].pose.displacement_m()) {
        best = static_cast<std::ptrdiff_t>(i);
      }
    }
    return best;
  }

  /// Carries the best pose over to the database scenes near the estimated position and verifies them too.
  void propagate(std::uint32_t scene_limit) {
    const std::ptrdiff_t best = choose();
    if (best < 0 || db_.settings.verify.propagate_most <= 0) return;
    const Verified from = verified_[static_cast<std::size_t>(best)];
    const RigidTransform survey_from_query = survey_from_aligned(from.scene) * from.pose.lifted();
    const Eigen::Vector3d here = survey_from_query.translation_m;
    nearby_.clear();
    db_.positions.each_near(here, db_.settings.verify.propagate_radius_m, [&](double distance_sq, std::uint32_t scene) {
      if (scene < scene_limit) nearby_.push_back({distance_sq, scene});
    });
    std::sort(nearby_.begin(), nearby_.end());
    if (nearby_.size() > static_cast<std::size_t>(db_.settings.verify.propagate_most)) {
      nearby_.resize(static_cast<std::size_t>(db_.settings.verify.propagate_most));
    }
    for (const auto& [distance_sq, scene] : nearby_) {
      verify(scene, 0, planar_part(survey_from_aligned(scene).inverse() * survey_from_query));
    }
  }

  RigidTransform survey_from_aligned(std::uint32_t scene) const {
    const Scene& s = db_.scenes[scene];
    return {s.survey_from_scene.rotation * s.aligned_from_scene.transpose(), s.survey_from_scene.translation_m};
  }

  Candidate candidate_of(const Verified& v, const Scene& query) {
    matcher_.pair(query_trees_.trees(0), db_.trees.trees(v.scene), v.pose, db_.settings.match.fine_m);
    const RefinedPose refined = refine_pose(query, db_.scenes[v.scene], matcher_.pairs(), v.pose, db_.settings.refine);
    const PlanarTrees in_query = query_trees_.trees(0), in_scene = db_.trees.trees(v.scene);
    Candidate c;
    c.scene = v.scene;
    c.pairs = v.pairs;
    c.votes = v.votes;
    c.displacement_m = refined.planar.displacement_m();
    c.score = overlap_score_linear(v.pairs, in_query.size(), in_scene.size(), c.displacement_m, db_.settings.verify.penalty_m);
    c.candidate_from_query = refined.candidate_from_query;
    return c;
  }

  double score_of(const Verified& v) const {
    return overlap_score_linear(v.pairs, query_trees_.trees(0).size(), db_.trees.trees(v.scene).size(), v.pose.displacement_m(),
                                db_.settings.verify.penalty_m);
  }

  /// Each scene once, the chosen one first, then by score; no more than will be put together.
  void keep_best(std::size_t chosen) {
    std::swap(verified_.front(), verified_[chosen]);
    std::stable_sort(verified_.begin() + 1, verified_.end(),
                     [&](const Verified& a, const Verified& b) { return score_of(a) > score_of(b); });
    std::size_t kept = 0;
    for (const Verified& v : verified_) {
      const auto end = verified_.begin() + static_cast<std::ptrdiff_t>(kept);
      if (std::any_of(verified_.begin(), end, [&](const Verified& k) { return k.scene == v.scene; })) continue;
      verified_[kept++] = v;
    }
    verified_.resize(std::min(kept, static_cast<std::size_t>(std::max(1, db_.settings.fuse.most))));
  }

  Localization answer(const Scene& query) {
    Localization found;
    const std::ptrdiff_t best = choose();
    if (best < 0) return found;
    keep_best(static_cast<std::size_t>(best));
    for (const Verified& v : verified_) found.candidates.push_back(candidate_of(v, query));
    Candidate& chosen = found.candidates.front();
    chosen.evidence =
        chance_evidence(chosen.pairs, query_trees_.trees(0), db_.trees.trees(chosen.scene), db_.settings.match.fine_m,
                        db_.settings.match.tau_dbh_m, db_.settings.vote.gate_m, db_.scenes.size());
    fuse(query, found);
    return found;
  }

  /// Replaces the chosen candidate's pose by the mean of what the strong ones say that agree with it; its covariance.
  void fuse(const Scene& query, Localization& found) {
    Candidate& chosen = found.candidates.front();
    const Scene& scene = db_.scenes[chosen.scene];
    RigidTransform fused = scene.survey_from_scene * chosen.candidate_from_query;
    std::vector<WeightedPose> poses;
    for (const Candidate& c : found.candidates) {
      const RigidTransform pose = db_.scenes[c.scene].survey_from_scene * c.candidate_from_query;
      if ((pose.translation_m - fused.translation_m).norm() > 1.5) continue;
      poses.push_back({pose, c.score});
    }
    if (!db_.settings.fuse.enabled) poses.clear();
    if (!poses.empty()) fused = fuse_poses(poses, db_.settings.fuse);
    if (!poses.empty()) chosen.candidate_from_query = scene.survey_from_scene.inverse() * fused;
    matcher_.pair(query_trees_.trees(0), db_.trees.trees(chosen.scene), verified_.front().pose, db_.settings.match.fine_m);
    const PoseCovariance alone =
        pair_covariance(query, scene, matcher_.pairs(), chosen.candidate_from_query, db_.settings.refine);
    found.covariance = fused_covariance(alone, scene.survey_from_scene.rotation, poses, fused, db_.settings.covariance);
  }

  const Database& db_;
  TriangleMaker maker_;
  SceneVote vote_;
  TreeMatcher matcher_;
  PlanarTreeStore query_trees_;
  std::vector<Verified> verified_;
  std::vector<std::pair<double, std::uint32_t>> nearby_;
};

class StemwiseLocalizer final : public Localizer {
public:
  explicit StemwiseLocalizer(const Settings& settings) : db_(settings) {}
  void add(DescribedScenes described, int threads) override {
    if (described.triangles) {
      db_.index.add(std::move(*described.triangles));
    } else {
      db_.index.add(described.scenes, threads);
    }
    for (Scene& scene : described.scenes) {
      db_.trees.add(scene);
      db_.scenes.push_back(std::move(scene));
    }
    db_.positions.update(db_.scenes);
  }
  const std::vector<Scene>& scenes() const override { return db_.scenes; }
  std::unique_ptr<QueryWorker> worker() const override { return std::make_unique<StemwiseWorker>(db_); }

private:
  Database db_;
};

}  // namespace

std::unique_ptr<Localizer> make_stemwise_localizer(const Settings& settings) {
  return std::make_unique<StemwiseLocalizer>(settings);
}

}  // namespace stemwise::treeloc
