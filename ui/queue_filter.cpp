#include "ui/queue_filter.hpp"

#include <algorithm>

#include "ui/derived.hpp"
#include "ui/view_state.hpp"

namespace stemwise::ui {
namespace {

bool is_of(const Derived& derived, const QueueRow& row, InventoryId inventory) {
  if (row.match) {
    const MatchRow& match = derived.tables.matches[*row.match];
    return match.a.inventory == inventory || match.b.inventory == inventory;
  }
  const std::vector<const ObservationRow*> seen = derived.sightings(row.tree);
  return std::any_of(seen.begin(), seen.end(), [&](const ObservationRow* o) { return o->stem.inventory == inventory; });
}

bool is_in(const MapRegion& region, const TreeRow& tree) {
  const double x = tree.position_m.x(), y = tree.position_m.y();
  return x >= region.low_x_m && x <= region.high_x_m && y >= region.low_y_m && y <= region.high_y_m;
}

}  // namespace

bool passes(const QueueFilter& filter, const ViewState& view, const Derived& derived, const QueueRow& row) {
  const TreeRow* tree = derived.tree(row.tree);
  if (view.only_fate && (tree == nullptr || tree->fate != *view.only_fate)) return false;
  if (filter.kind && kind_of(row) != *filter.kind) return false;
  if (filter.inventory && !is_of(derived, row, filter.inventory)) return false;
  if (filter.region && (tree == nullptr || !is_in(*filter.region, *tree))) return false;
  return filter.text.empty() || (tree_label(row.tree) + " " + row.why).find(filter.text) != std::string::npos;
}

QueueProgress progress_of(const QueueFilter& filter, const ViewState& view, const Derived& derived) {
  QueueProgress progress;
  for (const QueueRow& row : derived.tables.queue) {
    if (!passes(filter, view, derived, row)) continue;
    ++progress.all;
    progress.decided += row.decided ? 1 : 0;
  }
  return progress;
}

}  // namespace stemwise::ui
