#include "app/window/requests.hpp"
#include "core/geometry/drawn_polygon.hpp"
#include "core/project/commands.hpp"
#include "core/survey/coverage.hpp"
#include "ui/frame.hpp"

namespace stemwise {
namespace {

void select_in_polygon(WindowModel& m, const std::vector<Eigen::Vector3d>& corners_m, bool adds) {
  std::vector<Eigen::Vector2d> corners_px;
  for (const Eigen::Vector3d& corner : corners_m) corners_px.push_back(m.viewport.viewport().pixels_of(corner));
  std::vector<TreeId> trees = m.viewport.viewport().trees_in_polygon(corners_px);
  if (adds) trees.insert(trees.end(), m.view.group.begin(), m.view.group.end());
  select_group(m, std::move(trees));
  m.view.tool = ui::Tool::select;
}

void take_coverage(WindowModel& m, const std::vector<Eigen::Vector3d>& corners_m) {
  const InventoryId id = m.view.selected_inventory;
  if (!m.document.state().is_placed(id)) return;
  const RigidTransform inventory_from_reference = m.document.state().reference_from_inventory(id).inverse();
  std::vector<Eigen::Vector2d> own_m;
  for (const Eigen::Vector3d& corner : corners_m) own_m.push_back((inventory_from_reference * corner).head<2>());
  const Result<Polygon> polygon = drawn_polygon(own_m);
  if (!polygon) {
    m.notices.add_issues("The coverage was not changed", polygon.issues);
    return;
  }
  m.execute(set_coverage(id, {*polygon, CoverageSource::drawn}));
  m.view.layers.coverage = true;
  m.view.tool = ui::Tool::select;
}

}  // namespace

void finish_shape(WindowModel& m, const std::vector<Eigen::Vector3d>& corners_m, bool adds) {
  m.view.tool == ui::Tool::coverage ? take_coverage(m, corners_m) : select_in_polygon(m, corners_m, adds);
}

void start_shape(WindowModel& m, ui::Tool tool) {
  m.viewport.shape().forget();
  m.view.tool = m.view.tool == tool ? ui::Tool::select : tool;
  m.view.slide = m.view.before_after = m.view.blink = false;
}

void estimate_coverage_again(WindowModel& m, InventoryId id) {
  const Inventory* inventory = m.document.state().find(id);
  if (inventory != nullptr) m.execute(set_coverage(id, estimate_coverage(*inventory)));
}

}  // namespace stemwise
