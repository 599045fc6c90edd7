#include "core/survey/field_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/geometry/rigid_transform.hpp"

namespace stemwise {
namespace {

std::vector<const TreeRow*> sure_trees(const Tables& tables) {
  std::set<TreeId> doubtful;
  for (const QueueRow& row : tables.queue)
    if (!row.decided) doubtful.insert(row.tree);
  std::vector<const TreeRow*> sure;
  for (const TreeRow& tree : tables.trees) {
    const bool stands = tree.fate == Fate::survivor && !tables.inventories.empty() && tree.last_seen == tables.inventories.back();
    if (stands && tree.times_seen >= 2 && tree.confidence >= 0.9 && tree.flags.empty() && !doubtful.contains(tree.tree)) sure.push_back(&tree);
  }
  return sure;
}

std::vector<FieldBearing> bearings_to(const TreeRow& tree, const std::vector<const TreeRow*>& sure, double y_axis_azimuth_deg) {
  std::vector<std::pair<double, const TreeRow*>> near;
  for (const TreeRow* one : sure)
    if (one->tree != tree.tree) near.emplace_back((one->position_m - tree.position_m).head<2>().norm(), one);
  const std::size_t n = std::min<std::size_t>(3, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(n), near.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second->tree < b.second->tree;
  });
  std::vector<FieldBearing> out;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d way = (tree.position_m - near[i].second->position_m).head<2>();
    const double azimuth_deg = degrees(std::atan2(way.x(), way.y())) + y_axis_azimuth_deg;
    out.push_back({near[i].second->tree, near[i].first, std::fmod(azimuth_deg + 720.0, 360.0), near[i].second->dbh_m});
  }
  return out;
}

}  // namespace

NorthWords north_of(const Georeference& georeference) {
  if (georeference.kind == GeoreferenceKind::anchor) return {"true north", georeference.azimuth_deg};
  return {georeference.kind == GeoreferenceKind::crs ? "grid north" : "the reference's +y axis", 0.0};
}

FieldCheck make_field_check(const ProjectState& state, const Tables& tables, std::size_t most) {
  FieldCheck check;
  const NorthWords north = north_of(state.georeference);
  check.north = north.name;
  const std::vector<const TreeRow*> sure = sure_trees(tables);
  std::set<TreeId> taken;
  for (const QueueRow& queued : tables.queue) {
    if (check.rows.size() >= most) break;
    const TreeRow* tree = queued.decided ? nullptr : tables.find(queued.tree);
    if (tree == nullptr || !taken.insert(queued.tree).second) continue;
    check.rows.push_back({tree->tree, queued.why, tree->position_m, tree->has_z, tree->dbh_m, tree->species, bearings_to(*tree, sure, north.y_axis_azimuth_deg)});
  }
  return check;
}

}  // namespace stemwise
