#include "core/survey/merge_coincident.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/planar_index.hpp"

namespace stemwise {
namespace {

std::vector<std::size_t> usable(std::span<const Stem> stems) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < stems.size(); ++i)
    if (std::isfinite(stems[i].x_m) && std::isfinite(stems[i].y_m)) result.push_back(i);
  return result;
}


/// Mean of the extremes, to whole metres: a function of the set, not of the order of the rows.
Eigen::Vector2d middle(std::span<const Stem> stems, std::span<const std::size_t> used) {
  if (used.empty()) return Eigen::Vector2d::Zero();
  Eigen::Vector2d low(stems[used[0]].x_m, stems[used[0]].y_m), high = low;
  for (const std::size_t i : used) {
    const Eigen::Vector2d p(stems[i].x_m, stems[i].y_m);
    low = low.cwiseMin(p), high = high.cwiseMax(p);
  }
  return (0.5 * (low + high)).array().round();
}

}  // namespace

NodeList merge_coincident(std::span<const Stem> stems, double radius_m) {
  const auto used = usable(stems);
  NodeList list;
  list.origin_m = middle(stems, used);
  std::vector<Eigen::Vector2d> at;
  for (const std::size_t i : used) at.emplace_back(stems[i].x_m - list.origin_m.x(), stems[i].y_m - list.origin_m.y());
  const PlanarIndex index(at, std::max(PlanarIndex::usual_cell_m(at), radius_m));
  // A stem joins the node of the first stem within the radius; no chains, so that a dense thicket stays many nodes.
  std::vector<std::size_t> node_of(at.size(), at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    std::size_t first = i;
    index.within(at[i], radius_m, [&](std::size_t j, double) {
      if (j < first && node_of[j] < at.size() && list.members[node_of[j]].front() == used[j]) first = j;
    });
    if (first == i) {
      node_of[i] = list.members.size();
      list.members.emplace_back();
    } else {
      node_of[i] = node_of[first];
    }
    list.members[node_of[i]].push_back(used[i]);
  }
  for (const auto& members : list.members) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double dbh_cm = -1.0;
    for (const std::size_t i : members) {
      sum += Eigen::Vector2d(stems[i].x_m - list.origin_m.x(), stems[i].y_m - list.origin_m.y());
      const auto dbh_m = stems[i].dbh_for_matching_m();
      if (dbh_m && std::isfinite(*dbh_m) && *dbh_m > 0.0) dbh_cm = std::max(dbh_cm, 100.0 * *dbh_m);
    }
    list.at_m.push_back(sum / static_cast<double>(members.size()));
    list.dbh_cm.push_back(dbh_cm);
  }
  return list;
}

}  // namespace stemwise
