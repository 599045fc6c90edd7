#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/field.hpp"
#include "core/forest/frame_set.hpp"
#include "core/forest/inventory.hpp"
#include "core/jobs/progress.hpp"

namespace stemwise {

struct GlobalInventorySettings {
  double association_radius_m = 0.6;  ///< stems of different frames within this may be one tree
  double merge_radius_m = 0.4;        ///< trees nearer than this that are hardly ever seen side by side are one
  double position_noise_m = 0.08;     ///< scale of the robust position
  double search_radius_m = 4.0;       ///< how far a frame may be displaced and still be recognised
  double displaced_m = 0.5;           ///< a frame displaced by more than this moves no tree
  double doubtful_m = 0.25;           ///< a frame displaced by more than this is listed
  double height_bias_m = 0.25;        ///< frames whose base heights are off by this count half
  int least_sightings = 10;           ///< trees never reconstructed need so many frames to be believed
  Fields fields();
};

/// A frame that contradicts the trajectory: its trees are displaced against those of its neighbours.
struct FrameDoubt {
  std::int64_t number = 0;       ///< of the frame folder
  double displacement_m = 0.0;
  double agreement = 1.0;        ///< share of its stems that other frames saw too
  double weight = 1.0;           ///< 0..1, with which it took part
  std::string text;              ///< one sentence
};

struct GlobalInventoryReport {
  int frames = 0;
  int observations = 0, reconstructed_observations = 0;
  int left_out = 0;                         ///< observations of trees not believed
  int stems = 0, well_observed = 0;         ///< well observed: reconstructed, in three frames or more
  double position_residual_m = 0.0;         ///< median distance of reconstructed observations to their tree
  double height_bias_p95_m = 0.0;           ///< 95th percentile of the frames' base height bias
  double tilt_deg = 0.0;                    ///< of the survey's frame against its stems
  std::vector<FrameDoubt> down_weighted;    ///< in order of the frames
  std::vector<std::string> notes;
};

/// One frame's sighting of a global stem.
struct FrameSighting {
  std::int64_t frame_number = 0;
  std::int64_t stem = 0;  ///< index into that frame's stems
  bool operator==(const FrameSighting&) const = default;
};

struct GlobalInventory {
  std::vector<Stem> stems;                        ///< in the survey's frame; source_id "g1", "g2", ... in order of first sighting
  std::vector<std::vector<FrameSighting>> sightings;   ///< where each came from, in order of the frames
  GlobalInventoryReport report;
};

/// One stem list of a whole survey from its frames: the same tree seen from many frames becomes one stem with a robust
/// position, axis, base height and DBH. Only measured DBH enters `dbh_m`. Frames that contradict the trajectory are
/// down-weighted and listed. Deterministic; moving the survey moves the list. Throws Cancelled.
GlobalInventory build_global_inventory(const FrameSet& frames, const GlobalInventorySettings& settings = {},
                                       const Progress& progress = {});

/// The inventory as read from a frame folder, with its stems filled in and a note for every thing worth knowing. One that
/// has no frames, or has stems already, comes back as it is.
Inventory with_global_stems(Inventory inventory, const GlobalInventorySettings& settings = {}, const Progress& progress = {});

}  // namespace stemwise
