#pragma once
#include "core/base/random.hpp"
#include "core/simulate/simulate_forest.hpp"

namespace stemwise {

/// Any yaw, up to `shift_m` away, tilted: where a survey's own frame lies in the truth.
RigidTransform random_frame(const SimulateSettings& settings, Random& random);

/// Survey number `survey` of the trees: missed stems, false stems, noise, a frame of its own, rows in any order. Writes the
/// source ids into the trees' `then`.
SimulatedSurvey observe_stand(std::vector<TrueTree>& trees, std::size_t survey, Date date, const RigidTransform& truth_from_survey, const SimulateSettings& settings,
                              Random& random);

/// The same stand seen from a walk up and down its rows: a frame every 4 m with the living trees within 25 m, each with the
/// survey's noise anew. `stems` of the inventory stays empty: the global list is made from the frames.
FrameSet walk_through(const std::vector<TrueTree>& trees, std::size_t survey, const RigidTransform& truth_from_survey, const SimulateSettings& settings, Random& random);

}  // namespace stemwise
