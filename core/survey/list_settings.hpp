#pragma once
#include "core/base/field.hpp"

namespace stemwise {

/// How two bare stem lists are laid onto each other (stem-lists.md). One set of defaults for every site.
struct ListSettings {
  double merge_radius_m = 0.4;     ///< stems nearer than this are one node
  double cell_m = 0.4;             ///< vote cell of small lists
  double middle_cell_m = 0.6;      ///< vote cell of lists of more than scene_stems
  double coarse_cell_m = 1.0;      ///< vote cell of large lists
  int whole_list_stems = 420;      ///< up to this many nodes the query is the whole list
  int first_scenes = 3;            ///< which, beyond scene_stems, first asks with so many scenes: quicker where they suffice
  int scenes = 14;                 ///< larger lists ask with at most so many scenes
  int scene_stems = 140;           ///< of so many stems
  int peaks = 60;                  ///< vote peaks that are refined
  double noise_floor_m = 0.15;     ///< the position noise is never estimated below this
  double accept_log_ratio = 20.0;  ///< accepted from this Lambda - ln N
  double accept_margin = 15.0;     ///< and this margin
  double probable_log_ratio = 16.0;
  double probable_margin = 12.0;
  double margin_share = 0.18;      ///< the margin is also at least this share of Lambda
  Fields fields();
};

}  // namespace stemwise
