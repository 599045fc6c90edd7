#include "core/survey/list_settings.hpp"

namespace stemwise {

Fields ListSettings::fields() {
  return {{"lists.merge_radius_m", "m", "Stems closer than this are treated as one place while poses are searched.", &merge_radius_m},
          {"lists.cell_m", "m", "Size of a cell of the vote for lists of up to lists.scene_stems stems.", &cell_m},
          {"lists.middle_cell_m", "m", "Size of a cell of the vote for lists of up to lists.whole_list_stems stems.", &middle_cell_m},
          {"lists.coarse_cell_m", "m", "Size of a cell of the vote for larger lists.", &coarse_cell_m},
          {"lists.whole_list_stems", "", "Up to this many stems the whole list is the query.", &whole_list_stems},
          {"lists.first_scenes", "", "Scenes that are asked before such a whole list.", &first_scenes},
          {"lists.scenes", "", "A larger list asks with at most this many scenes.", &scenes},
          {"lists.scene_stems", "", "Stems of one scene.", &scene_stems},
          {"lists.peaks", "", "Peaks of the vote that are refined and scored.", &peaks},
          {"lists.noise_floor_m", "m", "The position noise is never estimated below this.", &noise_floor_m},
          {"lists.accept_log_ratio", "", "A pose is accepted from this log likelihood ratio after the poses tried.", &accept_log_ratio},
          {"lists.accept_margin", "", "A pose must lead the second best and the mirror image by this.", &accept_margin},
          {"lists.probable_log_ratio", "", "A pose is called probable from this log likelihood ratio.", &probable_log_ratio},
          {"lists.probable_margin", "", "A probable pose must lead by this.", &probable_margin},
          {"lists.margin_share", "", "The lead must also be this share of the log likelihood ratio.", &margin_share}};
}

}  // namespace stemwise
