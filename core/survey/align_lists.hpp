#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/jobs/progress.hpp"
#include "core/survey/accept_pose.hpp"
#include "core/survey/score_pose.hpp"
#include "core/survey/vote_poses.hpp"

namespace stemwise {

/// What is known before: all of it may be empty. Coordinates as in the lists.
struct ListHints {
  std::optional<double> years;          ///< from a to b
  std::optional<PoseWindow> rough_pose; ///< of a in b
  std::vector<std::pair<std::size_t, std::size_t>> same_tree;  ///< stems of a and b; two of them fix the pose
  bool pairs_ask = false;               ///< some of them were named to say where the lists lie; else all are decisions about trees
  std::vector<PlanarPose> proposals;    ///< b from a, from elsewhere (TreeLoc++ scenes): verified like every other pose
};

/// How list a lies on list b.
struct ListAlignment {
  AlignmentStatus status = AlignmentStatus::failed;  ///< aligned, probable or failed
  std::string reason;
  PlanarPose b_from_a;       ///< in the lists' own coordinates; the best pose found, whatever the status
  double noise_m = 0.0;      ///< one-axis standard deviation of matched stems' planar difference
  DbhModel dbh;              ///< from a to b
  PoseScore score;           ///< of that pose
  Acceptance acceptance;
  std::optional<PlanarPose> second_best;  ///< b from a
  std::vector<std::pair<std::size_t, std::size_t>> contradicted;  ///< of same_tree: stems that the pose lays metres apart
  int poses_refined = 0;
};

/// Steps 2 to 7 of stem-lists.md: finds, fits and judges the pose of one bare list in another. Swapping the lists gives the
/// inverse pose and the same verdict. Throws Cancelled.
ListAlignment align_lists(const IndexedList& a, const IndexedList& b, const ListHints& hints, const ListSettings& settings, int threads,
                          const Progress& progress);

}  // namespace stemwise
