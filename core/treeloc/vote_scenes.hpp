#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/treeloc/planar_pose.hpp"
#include "core/treeloc/step_settings.hpp"
#include "core/treeloc/triangle_index.hpp"

namespace stemwise::treeloc {

/// A scene that the vote proposes, with a first pose.
struct VotedScene {
  std::uint32_t scene = 0;
  int votes = 0;  ///< peak of its smoothed yaw histogram
  PlanarPose pose;
};

/// Votes of one query's triangles over an index. Keeps its buffers between queries: one per thread.
class SceneVote {
public:
  static constexpr int yaw_bins = 64;

  explicit SceneVote(const VoteSettings& settings);
  /// The scenes below `scene_limit` with the highest yaw peaks, best first (ties: lower scene). Valid until the next call.
  std::span<const VotedScene> vote(const TriangleIndex& index, std::span<const Triangle> query, std::uint32_t scene_limit);

private:
  /// A triangle of the query met one of the database: what it says about the pose.
  struct Hit {
    std::uint32_t scene;
    std::int16_t shift_x_cm, shift_y_cm;  ///< of the origins, in the triangle's frame
    std::uint8_t candidate_yaw;
    std::uint8_t yaw_difference;
  };
  /// A posting that passed the gate for a triangle of the query.
  struct Near {
    std::uint32_t place, triangle;
  };
  void collect_near(const TriangleIndex& index, std::size_t segment, const Triangle& t, std::uint32_t number);
  void vote_near(const TriangleIndex& index, std::size_t segment, std::span<const Triangle> query, std::uint32_t scene_limit);
  void collect_hits(const TriangleIndex& index, std::span<const Triangle> query, std::uint32_t scene_limit);
  void rank_scenes();
  int peak_of(std::uint32_t scene, int& bin) const;
  void sort_hits_by_rank();
  PlanarPose pose_from_hits(std::span<const Hit> hits, int bin) const;

  VoteSettings settings_;
  std::int32_t gate_sq_cm_ = 0;
  std::vector<float> cosine_, sine_;  ///< of the 256 directions
  std::vector<Near> near_;
  std::vector<Hit> hits_;
  std::vector<std::uint16_t> histogram_;  ///< yaw_bins per scene; zero between queries
  std::vector<std::uint32_t> total_;      ///< per scene; zero between queries
  std::vector<std::uint32_t> touched_;
  std::vector<std::int32_t> rank_;  ///< per scene, -1: not among the best
  struct Ranked {
    std::uint32_t scene;
    int votes;
    int bin;
  };
  std::vector<Ranked> ranked_;
  std::vector<std::uint32_t> first_hit_;
  std::vector<Hit> hits_of_ranked_;
  std::vector<VotedScene> result_;
};

}  // namespace stemwise::treeloc
