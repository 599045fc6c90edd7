#include "render/scene_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stemwise::render {
namespace {

constexpr double unknown_dbh_m = 0.08;

/// What a stem looks like apart from where it stands.
void add_form(Mark& mark, const Stem& stem, const Eigen::Matrix3d& rotation, std::optional<double> dbh_m) {
  mark.dbh_m = std::clamp(dbh_m.value_or(stem.dbh_for_matching_m().value_or(unknown_dbh_m)), 0.01, 4.0);
  mark.height_m = stem.height_m.value_or(display_height_m(mark.dbh_m));
  if (stem.axis && stem.axis->allFinite() && stem.axis->norm() > 1e-6) {
    mark.axis = (rotation * *stem.axis).normalized();
    if (mark.axis.z() < 0.0) mark.axis = -mark.axis;
  }
}

/// One pass over a project, split into what it adds.
class SceneBuilder {
 public:
  SceneBuilder(const ProjectState& state, const Tables& tables, const ViewOptions& options)
      : state_(state), tables_(tables), options_(options), color_by_(meaningful(options.color_by, tables)),
        colouring_(state, tables, color_by_, options.theme) {}

  SceneModel build() {
    scene_.reference = state_.reference;
    scene_.legend = colouring_.legend();
    scene_.surveys = static_cast<int>(tables_.inventories.size());
    scene_.shows_sightings = !is_whole();
    if (state_.georeference.kind == GeoreferenceKind::anchor) scene_.north_azimuth_rad = radians(state_.georeference.azimuth_deg);
    if (state_.georeference.kind == GeoreferenceKind::crs) scene_.north_azimuth_rad = 0.0;
    choose_origin();
    add_placed();
    add_links();
    add_coverages();
    add_side_frames();
    add_ghost();
    measure();
    return std::move(scene_);
  }

 private:
  bool is_hidden(InventoryId id) const { return std::find(options_.hidden.begin(), options_.hidden.end(), id) != options_.hidden.end(); }
  bool is_whole() const { return color_by_ != ColorBy::inventory; }

  /// Before anything is aligned there is nothing to compare: then surveys and diameters are all that colours can tell.
  static ColorBy meaningful(ColorBy by, const Tables& tables) {
    return tables.inventories.size() < 2 && by != ColorBy::dbh ? ColorBy::inventory : by;
  }

  void choose_origin() {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const ObservationRow& row : tables_.observations) {
      low = low.cwiseMin(row.position_m);
      high = high.cwiseMax(row.position_m);
    }
    if (low.allFinite()) scene_.origin_m = (0.5 * (low + high)).array().round();
  }

  /// For every tree the row of its newest shown sighting; -1 where none is shown.
  std::vector<std::int64_t> newest_rows() const {
    std::unordered_map<InventoryId, int> order;
    for (std::size_t i = 0; i < tables_.inventories.size(); ++i)
      if (!is_hidden(tables_.inventories[i])) order[tables_.inventories[i]] = static_cast<int>(i);
    std::int64_t most = 0;
    for (const ObservationRow& row : tables_.observations) most = std::max(most, row.tree.value);
    std::vector<std::int64_t> newest(static_cast<std::size_t>(most) + 1, -1);
    std::vector<int> newest_order(newest.size(), -1);
    for (std::size_t i = 0; i < tables_.observations.size(); ++i) {
      const ObservationRow& row = tables_.observations[i];
      const auto found = order.find(row.stem.inventory);
      const auto tree = static_cast<std::size_t>(std::max<std::int64_t>(0, row.tree.value));
      if (found == order.end() || tree == 0 || found->second < newest_order[tree]) continue;
      newest_order[tree] = found->second;
      newest[tree] = static_cast<std::int64_t>(i);
    }
    return newest;
  }

  /// Whether the tree's own fate (between the last two surveys) is what the shown surveys say.
  bool shows_last_two() const {
    const std::size_t n = tables_.inventories.size();
    return n < 2 || (!is_hidden(tables_.inventories[n - 1]) && !is_hidden(tables_.inventories[n - 2]));
  }

  void add_placed() {
    const std::vector<std::int64_t> newest = newest_rows();
    const bool tree_fate = shows_last_two();
    std::unordered_map<InventoryId, std::pair<const Inventory*, Eigen::Matrix3d>> forms;
    for (const InventoryId id : tables_.inventories)
      if (const Inventory* inventory = state_.find(id)) forms[id] = {inventory, state_.reference_from_inventory(id).rotation};
    scene_.marks.reserve(tables_.observations.size());
    const TreeRow* tree = nullptr;
    for (std::size_t i = 0; i < tables_.observations.size(); ++i) {
      const ObservationRow& row = tables_.observations[i];
      const auto form = forms.find(row.stem.inventory);
      if (form == forms.end() || is_hidden(row.stem.inventory)) continue;
      const bool is_newest = row.tree && newest[static_cast<std::size_t>(row.tree.value)] == static_cast<std::int64_t>(i);
      if (is_whole() && row.tree && !is_newest) continue;
      if (!tree || tree->tree != row.tree) tree = tables_.find(row.tree);
      Mark mark{.tree = row.tree, .stem = row.stem, .base_m = row.position_m - scene_.origin_m, .axis = Eigen::Vector3d::UnitZ()};
      if (!row.has_z) mark.base_m.z() = 0.0;
      heights_ += row.has_z;
      const Stem& stem = form->second.first->stems[static_cast<std::size_t>(row.stem.index)];
      add_form(mark, stem, form->second.second, row.dbh_m);
      mark.style = colouring_.style_of(row, tree, tree_fate);
      mark.times_seen = tree ? tree->times_seen : 0;
      mark.residual_m = row.residual_m;
      add_mark(mark, is_newest);
    }
  }

  void add_mark(const Mark& mark, bool is_newest) {
    const std::size_t at = scene_.marks.size();
    scene_.marks.push_back(mark);
    scene_.mark_of_stem[mark.stem] = at;
    if (mark.tree && is_newest) scene_.mark_of_tree[mark.tree] = at;
  }

  void add_links() {
    std::unordered_map<InventoryId, std::vector<std::int64_t>> row_of_stem;
    for (std::size_t i = 0; i < tables_.observations.size(); ++i) {
      const StemRef stem = tables_.observations[i].stem;
      auto& rows = row_of_stem[stem.inventory];
      if (static_cast<std::int64_t>(rows.size()) <= stem.index) rows.resize(static_cast<std::size_t>(stem.index) + 1, -1);
      rows[static_cast<std::size_t>(stem.index)] = static_cast<std::int64_t>(i);
    }
    const auto position = [&](StemRef stem) -> std::optional<Eigen::Vector3d> {
      const auto rows = row_of_stem.find(stem.inventory);
      if (rows == row_of_stem.end() || stem.index < 0 || stem.index >= static_cast<std::int64_t>(rows->second.size())) return std::nullopt;
      const std::int64_t row = rows->second[static_cast<std::size_t>(stem.index)];
      if (row < 0) return std::nullopt;
      const ObservationRow& seen = tables_.observations[static_cast<std::size_t>(row)];
      Eigen::Vector3d p = seen.position_m - scene_.origin_m;
      if (!seen.has_z) p.z() = 0.0;
      return p;
    };
    for (const MatchRow& match : tables_.matches) {
      if (match.state == MatchState::rejected || is_hidden(match.a.inventory) || is_hidden(match.b.inventory)) continue;
      const auto a = position(match.a), b = position(match.b);
      if (a && b) scene_.links.push_back({match.tree, *a, *b});
      if (!match.second_distance_m) continue;
      const auto found = state_.matches.find(ordered(match.a, match.b));
      if (found == state_.matches.end() || !found->second.second_choice) continue;
      if (const auto other = position(*found->second.second_choice)) scene_.alternative_of_tree[match.tree] = *other;
    }
  }

  void add_coverages() {
    for (const CoverageRow& row : tables_.coverages) {
      if (is_hidden(row.inventory) || row.in_reference.empty()) continue;
      CoverageShape shape{.inventory = row.inventory, .corners_m = {}, .outline = theme_colours(options_.theme).accent};
      if (color_by_ == ColorBy::inventory) shape.outline = colouring_.colour_of_inventory(row.inventory);
      for (const Eigen::Vector2d& corner : row.in_reference.corners_m) shape.corners_m.push_back(corner - scene_.origin_m.head<2>());
      scene_.coverages.push_back(std::move(shape));
    }
  }

  /// Surveys without a place stand in a row to the right of what has one, each in its own frame.
  void add_side_frames() {
    double next_x_m = 0.0, top_m = 0.0;
    bool is_first = scene_.marks.empty();
    SideFrame placed{state_.reference, -scene_.origin_m.head<2>(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), "", {}};
    for (const Mark& mark : scene_.marks) {
      placed.low_m = placed.low_m.cwiseMin(mark.base_m.head<2>());
      placed.high_m = placed.high_m.cwiseMax(mark.base_m.head<2>());
    }
    if (!is_first) next_x_m = placed.high_m.x(), top_m = placed.high_m.y();
    for (const auto& inventory : state_.inventories) {
      const bool is_placed = std::find(tables_.inventories.begin(), tables_.inventories.end(), inventory->id) != tables_.inventories.end();
      if (is_placed || is_hidden(inventory->id) || inventory->stems.empty()) continue;
      Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
      for (const Stem& stem : inventory->stems) {
        low = low.cwiseMin(Eigen::Vector2d(stem.x_m, stem.y_m));
        high = high.cwiseMax(Eigen::Vector2d(stem.x_m, stem.y_m));
      }
      const double gap_m = is_first ? 0.0 : 0.2 * std::max(20.0, (high - low).maxCoeff());
      const Eigen::Vector2d offset = Eigen::Vector2d(next_x_m + gap_m, top_m) - Eigen::Vector2d(low.x(), high.y());
      add_side_frame(*inventory, offset, low + offset, high + offset);
      next_x_m = high.x() + offset.x();
      is_first = false;
    }
    const Inventory* reference = state_.find(state_.reference);
    if (scene_.side_frames.empty() || !reference || placed.low_m == placed.high_m) return;
    const bool is_alone = tables_.inventories.size() < 2;
    placed.caption = is_alone ? reference->name + ", reference" : "Aligned surveys";
    placed.colour = is_alone ? colouring_.colour_of_inventory(reference->id) : theme_colours(options_.theme).text;
    scene_.side_frames.push_back(placed);
  }

  const char* standing_of(InventoryId id) const {
    const auto found = state_.alignments.find(id);
    const AlignmentStatus status = found == state_.alignments.end() ? AlignmentStatus::unaligned : found->second.status;
    return status == AlignmentStatus::failed ? "refused" : status == AlignmentStatus::probable ? "probable pose" : "not aligned yet";
  }

  void add_side_frame(const Inventory& inventory, const Eigen::Vector2d& offset, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    const Rgba colour = colouring_.colour_of_inventory(inventory.id);
    scene_.side_frames.push_back({inventory.id, offset, low, high, inventory.name + ", " + standing_of(inventory.id), colour});
    double mean_z_m = 0.0;
    int count = 0;
    for (const Stem& stem : inventory.stems)
      if (stem.z_m) mean_z_m += *stem.z_m, ++count;
    if (count > 0) mean_z_m /= count;
    for (std::size_t i = 0; i < inventory.stems.size(); ++i) {
      const Stem& stem = inventory.stems[i];
      Mark mark{.tree = {}, .stem = {inventory.id, static_cast<std::int64_t>(i)}, .axis = Eigen::Vector3d::UnitZ()};
      mark.base_m = {stem.x_m + offset.x(), stem.y_m + offset.y(), stem.z_m.value_or(mean_z_m) - mean_z_m};
      heights_ += stem.z_m.has_value();
      add_form(mark, stem, Eigen::Matrix3d::Identity(), stem.dbh_m);
      mark.style = colouring_.style_of_unplaced(inventory.id, stem);
      add_mark(mark, false);
    }
  }

  void add_ghost() {
    const Inventory* inventory = options_.ghost ? state_.find(options_.ghost->inventory) : nullptr;
    if (!inventory) return;
    const RigidTransform& pose = options_.ghost->reference_from_inventory;
    for (std::size_t i = 0; i < inventory->stems.size(); ++i) {
      const Stem& stem = inventory->stems[i];
      Mark mark{.tree = {}, .stem = {inventory->id, static_cast<std::int64_t>(i)}, .axis = Eigen::Vector3d::UnitZ()};
      mark.base_m = pose * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0)) - scene_.origin_m;
      if (!stem.z_m) mark.base_m.z() = 0.0;
      add_form(mark, stem, pose.rotation, stem.dbh_m);
      mark.style = {colouring_.colour_of_inventory(inventory->id), MarkShape::hollow};
      scene_.ghosts.push_back(mark);
    }
  }

  void measure() {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Mark& mark : scene_.marks) {
      low = low.cwiseMin(mark.base_m);
      high = high.cwiseMax(mark.base_m);
    }
    for (const CoverageShape& shape : scene_.coverages)
      for (const Eigen::Vector2d& corner : shape.corners_m) {
        low.head<2>() = low.head<2>().cwiseMin(corner);
        high.head<2>() = high.head<2>().cwiseMax(corner);
      }
    if (scene_.marks.empty()) low = high = Eigen::Vector3d::Zero();
    scene_.low_m = low;
    scene_.high_m = high;
    scene_.has_terrain = heights_ >= 3;
    measure_spacing();
  }

  void measure_spacing() {
    const Eigen::Vector3d &low = scene_.low_m, &high = scene_.high_m;
    const double trees = std::max<double>(1.0, static_cast<double>(scene_.mark_of_tree.size() + (scene_.mark_of_tree.empty() ? scene_.marks.size() : 0)));
    const Eigen::Vector2d extent = (high - low).head<2>();
    scene_.spacing_m = std::clamp(std::sqrt(std::max(1.0, extent.x() * extent.y()) / trees), 0.5, 30.0);
    double sum_sq = 0.0;
    for (const Link& link : scene_.links) sum_sq += (link.b_m - link.a_m).head<2>().squaredNorm();
    const double rms_m = std::sqrt(sum_sq / std::max<double>(1.0, static_cast<double>(scene_.links.size())));
    const double wanted = rms_m > 1e-6 ? 0.45 * scene_.spacing_m / rms_m : 1.0;
    for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
      if (factor <= wanted) scene_.residual_factor = factor;
  }

  const ProjectState& state_;
  const Tables& tables_;
  const ViewOptions& options_;
  ColorBy color_by_;
  Colouring colouring_;
  SceneModel scene_;
  std::int64_t heights_ = 0;
};

template <class Key>
const Mark* look_up(const SceneModel& scene, const std::unordered_map<Key, std::size_t>& index, const Key& key) {
  const auto found = index.find(key);
  return found == index.end() ? nullptr : &scene.marks[found->second];
}

}  // namespace

const Mark* SceneModel::find(TreeId tree) const { return look_up(*this, mark_of_tree, tree); }
const Mark* SceneModel::find(StemRef stem) const { return look_up(*this, mark_of_stem, stem); }

double display_height_m(double dbh_m) { return 1.3 + 30.0 * (1.0 - std::exp(-3.2 * dbh_m)); }

SceneModel build_scene(const ProjectState& state, const Tables& tables, const ViewOptions& options) {
  return SceneBuilder(state, tables, options).build();
}

}  // namespace stemwise::render
