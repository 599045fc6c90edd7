#include "core/treeloc/verify_scenes.hpp"

#include <cmath>

namespace stemwise::treeloc {

Fields VerifySettings::fields(const std::string& prefix) {
  return {
      {prefix + ".strong_share", "", "Among candidates with this share of the most pairs the nearest one is chosen",
       &strong_share},
      {prefix + ".propagate_radius_m", "m", "Scenes this near to the estimated position are verified too", &propagate_radius_m},
      {prefix + ".propagate_most", "", "At most so many of them (0: none)", &propagate_most},
      {prefix + ".penalty_m", "m", "Displacement at which the score falls to 1/e", &penalty_m},
      {prefix + ".min_pairs", "", "Matched trees that a candidate needs", &min_pairs}};
}

double overlap_score_linear(int pairs, std::size_t query_trees, std::size_t candidate_trees, double displacement_m,
                            double penalty_m) {
  const double either = static_cast<double>(query_trees + candidate_trees) - pairs;
  return either > 0.0 ? pairs / either * std::exp(-displacement_m / penalty_m) : 0.0;
}

}  // namespace stemwise::treeloc
