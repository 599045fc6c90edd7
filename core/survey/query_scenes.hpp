#pragma once
#include <vector>

#include "core/survey/list_settings.hpp"
#include "core/survey/list_pair.hpp"

namespace stemwise {

/// A part of a list that asks "where am I in the other one?".
struct Scene {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;             ///< of the farthest node from the centre
  std::vector<std::size_t> nodes;
  bool whole_list = false;
  double cell_m = 0.4;               ///< of the vote
};

/// Step 3 of stem-lists.md: the whole list while it is small (of a middling one some scenes first, because they are much
/// quicker and usually enough); else well-spread scenes of the nodes nearest to a centre, the first in the middle, every next
/// one farthest from those before it. In the order in which they are to be asked.
std::vector<Scene> query_scenes(const IndexedList& list, const ListSettings& settings);

}  // namespace stemwise
