#include "core/survey/unit_doubt.hpp"

#include <cstdio>
#include <map>

#include "core/base/quantile.hpp"

namespace stemwise {
namespace {

constexpr double least_ratio = 0.6, largest_ratio = 1.7;
constexpr std::size_t least_pairs = 8;

/// Later over earlier diameter of every match that joins, by the surveys' places in the order of dates.
std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> ratios_of(const ProjectState& state) {
  std::map<InventoryId, std::size_t> place;
  for (const InventoryId id : state.by_date()) place.try_emplace(id, place.size());
  std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> ratios;
  for (const auto& [key, match] : state.matches) {
    if (!match.joins()) continue;
    const bool in_order = place.at(match.a.inventory) < place.at(match.b.inventory);
    const StemRef first = in_order ? match.a : match.b, second = in_order ? match.b : match.a;
    const Stem *earlier = state.find(first), *later = state.find(second);
    if (earlier->dbh_m && later->dbh_m) ratios[{place.at(first.inventory), place.at(second.inventory)}].push_back(*later->dbh_m / *earlier->dbh_m);
  }
  return ratios;
}

}  // namespace

std::vector<std::string> unit_doubts(const ProjectState& state) {
  const std::vector<InventoryId> order = state.by_date();
  std::vector<std::string> doubts;
  for (const auto& [pair, ratios] : ratios_of(state)) {
    const double ratio = median(ratios);
    if (ratios.size() < least_pairs || (ratio >= least_ratio && ratio <= largest_ratio)) continue;
    char times[32];
    std::snprintf(times, sizeof times, "%.2f", ratio);
    doubts.push_back("the diameters of " + state.find(order[pair.second])->name + " are " + times + " times those of " + state.find(order[pair.first])->name +
                     " in the median of their matched stems: was one of them read in a wrong unit?");
  }
  return doubts;
}

}  // namespace stemwise
