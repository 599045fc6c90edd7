#pragma once
#include <span>
#include <vector>

#include "core/forest/frame_set.hpp"
#include "core/treeloc/align_axes.hpp"
#include "core/treeloc/scene.hpp"
#include "core/treeloc/sensor_height.hpp"
#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

/// The scene of frame `index`: its own trees, filled up from preceding frames and with candidate stems where there are
/// few, turned so that the dominant stem axis is +z (eq. 1-2).
Scene prepare_frame_scene(const FrameSet& set, std::size_t index, const PrepareSettings& settings, const AlignAxesSettings& axes);

/// The scene of the trees of a global list within the settings' radius of a position (x, y in the survey's frame, metres).
/// Its frame is the survey's, shifted to `center_m`.
Scene prepare_cut_scene(std::span<const Stem> stems, std::span<const std::size_t> nearby, const Eigen::Vector3d& center_m,
                        std::int64_t number, const PrepareSettings& settings, const AlignAxesSettings& axes);

/// All scenes of a frame set, in its order; marked where the survey's sensor was carried at a constant height.
std::vector<Scene> prepare_frame_scenes(const FrameSet& set, const PrepareSettings& settings, const AlignAxesSettings& axes,
                                        int threads);

/// Scenes on a square grid over a global list (method.md, section 9); positions with fewer than `min_trees` trees give none.
std::vector<Scene> prepare_grid_scenes(std::span<const Stem> stems, double spacing_m, int min_trees,
                                       const PrepareSettings& settings, const AlignAxesSettings& axes, int threads);

}  // namespace stemwise::treeloc
