#include "core/survey/decide_fate.hpp"

#include <algorithm>

#include "core/geometry/near_edge.hpp"

namespace stemwise {
namespace {

enum class Place { inside, edge, outside };

/// Within a metre, two position errors, or what the outline itself may be off, of the edge nobody can say whether the survey looked there.
Place place_in(const SurveyFootprint& survey, const Eigen::Vector2d& position_m) {
  if (survey.coverage_in_reference.empty()) return Place::inside;
  const double doubt_m = std::max({1.0, 2.0 * survey.position_noise_m, survey.outline_doubt_m});
  if (is_near_edge(survey.coverage_in_reference, position_m, doubt_m)) return Place::edge;
  return contains(survey.coverage_in_reference, position_m) ? Place::inside : Place::outside;
}

Fate fate_of_new(const SurveyStep& step, const TreeAtStep& tree) {
  if (place_in(*step.from, tree.position_in_reference_m) == Place::outside) return Fate::outside_coverage;
  if (!tree.dbh_in_to_m) return Fate::unresolved;
  const double ingrowth_limit_m = step.from->smallest_dbh_m + step.most_growth_m;
  return *tree.dbh_in_to_m <= ingrowth_limit_m ? Fate::ingrowth : Fate::missed_earlier;
}

Fate fate_of_gone(const SurveyStep& step, const TreeAtStep& tree) {
  switch (place_in(*step.to, tree.position_in_reference_m)) {
    case Place::outside: return Fate::outside_coverage;
    case Place::edge: return Fate::unresolved;
    case Place::inside: break;
  }
  return Fate::missing;
}

/// What a field code alone decides.
std::optional<Fate> fate_of_code(StemStatus code) {
  if (code == StemStatus::dead) return Fate::dead;
  return code == StemStatus::removed ? std::optional(Fate::removed) : std::nullopt;
}

}  // namespace

Fate decide_fate(const SurveyStep& step, const TreeAtStep& tree) {
  if (tree.by_hand) return *tree.by_hand;
  const bool known_before = tree.seen_from || tree.seen_earlier;
  if (tree.seen_to) {
    if (const auto told = fate_of_code(tree.code_in_to)) return *told;
    return known_before ? Fate::survivor : fate_of_new(step, tree);
  }
  if (!known_before) return tree.seen_later ? Fate::outside_coverage : Fate::unresolved;
  if (tree.seen_later) return Fate::survivor;
  if (const auto told = fate_of_code(tree.code_before)) return *told;  // it lay or stood dead already; nobody has to look for it
  return fate_of_gone(step, tree);
}

}  // namespace stemwise
