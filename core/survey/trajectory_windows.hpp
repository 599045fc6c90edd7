#pragma once
#include <optional>
#include <vector>

#include "core/forest/inventory.hpp"
#include "core/jobs/progress.hpp"
#include "core/survey/list_pair.hpp"
#include "core/survey/register_trajectories.hpp"

namespace stemwise {

/// A stretch of way short enough that drift within it does not matter, as one small stem list in the survey's frame.
struct TrajectoryWindow {
  std::size_t first = 0, last = 0, middle = 0;  ///< frames, both ends included
  IndexedList list;
};

std::vector<TrajectoryWindow> windows_along(const FrameSet& frames, const RegisterSettings& settings);

/// Where in the bare list each window lies (list from survey, as it holds around that window); nothing where it is not sure.
/// One window is found without a guess and accepted like every pose; the others follow from their neighbours. `guess`, where
/// given, has one pose per window instead.
std::vector<std::optional<PlanarPose>> place_windows(const std::vector<TrajectoryWindow>& windows, const IndexedList& list, std::optional<double> years,
                                                     const std::vector<PlanarPose>& guess, const RegisterSettings& settings, int threads, const Progress& progress);

}  // namespace stemwise
