#pragma once
#include <optional>
#include <vector>

#include "core/jobs/progress.hpp"
#include "core/survey/query_scenes.hpp"

namespace stemwise {

/// A rough pose that a person gave, and how far off it may be. `b_from_a` in node coordinates.
struct PoseWindow {
  PlanarPose b_from_a;
  Eigen::Vector2d about_m = Eigen::Vector2d::Zero();  ///< the point of a whose image is known to within radius_m
  double radius_m = 10.0;
  double yaw_radius_rad = 0.35;
  bool same_stand = false;  ///< known beforehand (one coordinate system): only which pose of the window is asked
  bool accepted = false;    ///< a person looked at this pose and takes it: it need not prove itself
};

/// A cell of the vote that stands out against chance.
struct PosePeak {
  PlanarPose b_from_a;
  double surprise = 0.0;  ///< V ln(V/E) - V + E
};

struct VoteSettings {
  int peaks = 60;
  int threads = 0;
  std::optional<PoseWindow> window;
};

/// The cell of the vote: the scene's own, or larger where a few stray stems would make the search endless.
double vote_cell_m(const Scene& scene, const IndexedList& b);

/// Step 4 of stem-lists.md: every pair of stems whose diameters could be one stem's votes for the shift that joins them, at
/// every yaw; cells are ranked by how far their votes exceed what other yaws put there. Best first. Throws Cancelled.
std::vector<PosePeak> vote_poses(const IndexedList& a, const Scene& scene, const IndexedList& b, const DbhModel& model,
                                 const VoteSettings& settings, const Progress& progress);

}  // namespace stemwise
