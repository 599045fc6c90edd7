#include "io/project_layers.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "io/crs.hpp"
#include "io/exact_number.hpp"
#include "io/forestgeo_layer.hpp"

namespace stemwise {
namespace {

constexpr std::array<const char*, layer_kind_count + 1> layer_words = {"trees", "observations", "matches", "links", "inventories", "coverage", "forestgeo"};
constexpr double unknown_height = std::numeric_limits<double>::quiet_NaN();
constexpr int metre_decimals = 4;
constexpr int degree_decimals = 9;  // 0.1 mm on the ground

LayerColumn text_column(std::string name, std::string description) { return {std::move(name), ColumnType::text, 0, std::move(description)}; }
LayerColumn real_column(std::string name, int decimals, std::string description) {
  return {std::move(name), ColumnType::real, decimals, std::move(description)};
}

LayerValue real(std::optional<double> value) { return value ? LayerValue(*value) : LayerValue(); }
LayerValue cm(std::optional<double> value_m) { return value_m ? LayerValue(100.0 * *value_m) : LayerValue(); }
LayerValue label(TreeId id) { return id ? LayerValue(tree_label(id)) : LayerValue(); }

std::string joined(const std::vector<std::string>& flags) {
  std::string text;
  for (const std::string& flag : flags) text += (text.empty() ? "" : ";") + flag;
  return text;
}

/// Makes the layers of one project.
class LayerMaker {
 public:
  LayerMaker(const ProjectState& state, const Tables& tables, const EarthFrame& frame) : state_(state), tables_(tables), frame_(frame) {}

  Layer make(LayerKind kind) const {
    switch (kind) {
      case LayerKind::trees: return trees();
      case LayerKind::observations: return observations();
      case LayerKind::matches: return matches(false);
      case LayerKind::links: return matches(true);
      case LayerKind::inventories: return inventories();
      case LayerKind::coverage: return coverage();
      case LayerKind::forestgeo: break;
    }
    return forestgeo_layer(state_, tables_);
  }

 private:
  Layer layer(LayerKind kind, std::string title, LayerGeometry geometry) const {
    Layer l;
    l.name = to_string(kind);
    l.title = std::move(title);
    l.geometry = geometry;
    l.epsg = frame_.epsg();
    return l;
  }

  int coordinate_decimals() const { return frame_.epsg() && is_geographic_epsg(*frame_.epsg()) ? degree_decimals : metre_decimals; }

  void add_xyz(Layer& l) const {
    const std::string where = frame_.epsg() ? "in " + crs_name(*frame_.epsg()) : "in the reference's frame, m";
    l.columns.push_back(real_column("x", coordinate_decimals(), "easting or longitude " + where));
    l.columns.push_back(real_column("y", coordinate_decimals(), "northing or latitude " + where));
    l.columns.push_back(real_column("z", metre_decimals, "height of the stem's base" + (frame_.epsg() ? " above " + frame_.height_datum() : std::string()) + ", m; empty when unknown"));
  }

  /// x, y, z of a point, and its corner.
  void set_xyz(LayerFeature& f, const Eigen::Vector3d& in_reference_m, bool has_z) const {
    const auto p = frame_.target_from_reference(in_reference_m);
    if (!p) {
      f.values.insert(f.values.end(), 3, LayerValue());
      return;
    }
    f.values.push_back(p->x());
    f.values.push_back(p->y());
    f.values.push_back(has_z ? LayerValue(p->z()) : LayerValue());
    f.corners.push_back({p->x(), p->y(), has_z ? p->z() : unknown_height});
  }

  const std::string& name(InventoryId id) const {
    static const std::string none;
    const Inventory* inventory = id ? state_.find(id) : nullptr;
    return inventory != nullptr ? inventory->name : none;
  }

  const std::string& source_id(StemRef ref) const {
    static const std::string none;
    const Stem* stem = state_.find(ref);
    return stem != nullptr ? stem->source_id : none;
  }

  Layer trees() const {
    Layer l = layer(LayerKind::trees, "Merged trees", LayerGeometry::point);
    l.columns.push_back(text_column("tree_id", "id of the tree, the same in every run and export"));
    add_xyz(l);
    l.columns.push_back(real_column("lon", degree_decimals, "longitude, WGS 84, degrees"));
    l.columns.push_back(real_column("lat", degree_decimals, "latitude, WGS 84, degrees"));
    l.columns.push_back(real_column("height", metre_decimals, "height above " + frame_.height_datum() + ", m"));
    l.columns.push_back(real_column("position_sd_m", 3, "standard deviation of the position, one axis, with that of the georeference, m"));
    l.columns.push_back(real_column("dbh_cm", 2, "diameter at breast height by the fusion policy, cm"));
    l.columns.push_back(text_column("dbh_source", "inventory the diameter comes from"));
    l.columns.push_back(text_column("species", "species as the inventories name it"));
    l.columns.push_back(text_column("fate", "between the last two inventories by date"));
    l.columns.push_back(text_column("first_seen", "first inventory that has the tree"));
    l.columns.push_back(text_column("last_seen", "last inventory that has the tree"));
    l.columns.push_back({"times_seen", ColumnType::integer, 0, "inventories that have the tree"});
    for (const InventoryId id : tables_.inventories) l.columns.push_back(real_column("dbh_" + name(id) + "_cm", 2, "diameter in " + name(id) + ", cm"));
    l.columns.push_back(real_column("growth_cm_per_year", 3, "change of the diameter from first to last measurement, cm per year"));
    l.columns.push_back(text_column("flags", "names of rules, separated by semicolons"));
    l.columns.push_back(text_column("note", "a person's note"));
    l.columns.push_back(text_column("edited_by", "who changed the tree by hand"));
    l.features.reserve(tables_.trees.size());
    for (const TreeRow& row : tables_.trees) l.features.push_back(tree(row));
    return l;
  }

  /// The survey that the merged diameter is from; of a mean all of them.
  std::string dbh_source(const TreeRow& row) const {
    if (row.dbh_source || !row.dbh_m) return name(row.dbh_source);
    std::string all;
    for (std::size_t i = 0; i < tables_.inventories.size() && i < row.dbh_per_inventory_m.size(); ++i)
      if (row.dbh_per_inventory_m[i]) all += (all.empty() ? "mean of " : ", ") + name(tables_.inventories[i]);
    return all;
  }

  LayerFeature tree(const TreeRow& row) const {
    LayerFeature f;
    f.values.push_back(label(row.tree));
    set_xyz(f, row.position_m, row.has_z);
    const auto g = frame_.geodetic_from_reference(row.position_m);
    f.values.push_back(g ? LayerValue(g->longitude_deg) : LayerValue());
    f.values.push_back(g ? LayerValue(g->latitude_deg) : LayerValue());
    f.values.push_back(g && row.has_z ? LayerValue(frame_.given_height_m(*g)) : LayerValue());
    f.values.insert(f.values.end(), {LayerValue(frame_.position_sd_m(row.position_m, row.position_sd_m)), cm(row.dbh_m), LayerValue(dbh_source(row)), LayerValue(row.species),
                                     LayerValue(to_string(row.fate)), LayerValue(name(row.first_seen)), LayerValue(name(row.last_seen)),
                                     LayerValue(std::int64_t{row.times_seen})});
    for (std::size_t i = 0; i < tables_.inventories.size(); ++i) {
      f.values.push_back(i < row.dbh_per_inventory_m.size() ? cm(row.dbh_per_inventory_m[i]) : LayerValue());
    }
    f.values.insert(f.values.end(), {cm(row.growth_m_per_year), LayerValue(joined(row.flags)), LayerValue(row.note), LayerValue(row.edited_by)});
    return f;
  }

  Layer observations() const {
    Layer l = layer(LayerKind::observations, "Stems of every inventory", LayerGeometry::point);
    l.columns.push_back(text_column("tree_id", "tree the stem belongs to"));
    l.columns.push_back(text_column("inventory", "inventory that saw the stem"));
    l.columns.push_back(text_column("source_id", "id in the file that was read, or its row"));
    add_xyz(l);
    l.columns.push_back(real_column("dbh_cm", 2, "measured diameter at breast height, cm"));
    l.columns.push_back(real_column("dbh_error_cm", 2, "error of one measurement, cm"));
    l.columns.push_back(text_column("fate", "from this inventory to the next"));
    l.columns.push_back(real_column("residual_m", 3, "planar distance to the tree's merged position, m"));
    l.columns.push_back(real_column("confidence", 3, "of the match, 0 to 1"));
    l.columns.push_back(text_column("flags", "names of rules, separated by semicolons"));
    l.features.reserve(tables_.observations.size());
    for (const ObservationRow& row : tables_.observations) {
      LayerFeature f;
      f.values = {label(row.tree), LayerValue(name(row.stem.inventory)), LayerValue(source_id(row.stem))};
      set_xyz(f, row.position_m, row.has_z);
      f.values.insert(f.values.end(), {cm(row.dbh_m), cm(row.dbh_error_m), LayerValue(to_string(row.fate)), real(row.residual_m), real(row.confidence),
                                       LayerValue(joined(row.flags))});
      l.features.push_back(std::move(f));
    }
    add_unplaced(l);
    return l;
  }

  /// Stems of inventories that were not aligned: they have no place in the common frame, but they were observed.
  void add_unplaced(Layer& l) const {
    for (const auto& inventory : state_.inventories) {
      if (std::find(tables_.inventories.begin(), tables_.inventories.end(), inventory->id) != tables_.inventories.end()) continue;
      for (const Stem& stem : inventory->stems) {
        LayerFeature f;
        f.values = {LayerValue(), LayerValue(inventory->name), LayerValue(stem.source_id), LayerValue(), LayerValue(), LayerValue(), cm(stem.dbh_m), LayerValue(),
                    LayerValue(to_string(Fate::unresolved)), LayerValue(), LayerValue(), LayerValue("not_aligned")};
        l.features.push_back(std::move(f));
      }
    }
  }

  Layer matches(bool as_links) const {
    Layer l = layer(as_links ? LayerKind::links : LayerKind::matches, as_links ? "Links between matched stems" : "Matches",
                    as_links ? LayerGeometry::line : LayerGeometry::none);
    for (const auto& [column, text] : {std::pair("tree_id", "the tree"), std::pair("inventory_a", "the earlier inventory"), std::pair("source_id_a", "stem in it"),
                                       std::pair("inventory_b", "the later inventory"), std::pair("source_id_b", "stem in it")}) {
      l.columns.push_back(text_column(column, text));
    }
    l.columns.push_back(real_column("distance_m", 3, "planar distance of the two stems, m"));
    l.columns.push_back(real_column("dbh_a_cm", 2, "diameter in the earlier, cm"));
    l.columns.push_back(real_column("dbh_b_cm", 2, "diameter in the later, cm"));
    l.columns.push_back(real_column("dbh_change_cm", 2, "change of the diameter, cm"));
    l.columns.push_back(real_column("years", 3, "between the two, years of 365.25 days"));
    l.columns.push_back(real_column("growth_cm_per_year", 3, "change per year, cm"));
    l.columns.push_back(text_column("change_class", "grew, shrank, within_error, unknown"));
    l.columns.push_back(real_column("confidence", 3, "0 to 1"));
    l.columns.push_back(text_column("state", "automatic, accepted, rejected, linked"));
    l.columns.push_back(text_column("flags", "names of rules, separated by semicolons"));
    l.features.reserve(tables_.matches.size());
    for (const MatchRow& row : tables_.matches) l.features.push_back(match(row, as_links));
    return l;
  }

  LayerFeature match(const MatchRow& row, bool with_line) const {
    LayerFeature f;
    f.values = {label(row.tree), LayerValue(name(row.a.inventory)), LayerValue(source_id(row.a)), LayerValue(name(row.b.inventory)),
                LayerValue(source_id(row.b)), LayerValue(row.distance_m), cm(row.dbh_a_m), cm(row.dbh_b_m), cm(row.change_m), real(row.years),
                cm(row.growth_m_per_year), LayerValue(to_string(row.change)), LayerValue(row.confidence), LayerValue(to_string(row.state)),
                LayerValue(joined(row.flags))};
    if (!with_line || !state_.is_placed(row.a.inventory) || !state_.is_placed(row.b.inventory)) return f;
    const auto a = frame_.target_from_reference(state_.stem_in_reference_m(row.a));
    const auto b = frame_.target_from_reference(state_.stem_in_reference_m(row.b));
    if (a && b) f.corners = {{a->x(), a->y(), unknown_height}, {b->x(), b->y(), unknown_height}};
    return f;
  }

  Layer inventories() const {
    Layer l = layer(LayerKind::inventories, "Inventories", LayerGeometry::none);
    l.columns = {text_column("name", "name of the inventory"), text_column("date", "day of the survey"),
                 {"trees", ColumnType::integer, 0, "stems"}, text_column("status", "reference, aligned, probable, failed, unaligned"),
                 real_column("overlap", 3, "share of common stems inside both coverages, 0 to 1"), real_column("residual", 3, "root mean square of the matched stems' distances, m"),
                 text_column("pose", "T_reference_from_inventory, row by row, m")};
    for (const auto& inventory : state_.inventories) {
      LayerFeature f;
      f.values = {LayerValue(inventory->name), inventory->date ? LayerValue(to_string(*inventory->date)) : LayerValue(),
                  LayerValue(static_cast<std::int64_t>(inventory->stems.size()))};
      const auto a = state_.alignments.find(inventory->id);
      const bool is_reference = inventory->id == state_.reference;
      const bool known = a != state_.alignments.end();
      f.values.push_back(LayerValue(to_string(known ? a->second.status : is_reference ? AlignmentStatus::reference : AlignmentStatus::unaligned)));
      f.values.push_back(known && !is_reference ? LayerValue(a->second.overlap) : LayerValue());
      f.values.push_back(known && !is_reference ? LayerValue(a->second.residual_rms_m) : LayerValue());
      f.values.push_back(state_.is_placed(inventory->id) ? LayerValue(pose_text(state_.reference_from_inventory(inventory->id))) : LayerValue());
      l.features.push_back(std::move(f));
    }
    return l;
  }

  static std::string pose_text(const RigidTransform& pose) {
    const Eigen::Matrix4d m = pose.matrix();
    std::string text = "[";
    for (int r = 0; r < 4; ++r) {
      text += r > 0 ? ",[" : "[";
      for (int c = 0; c < 4; ++c) text += (c > 0 ? "," : "") + exact_text(m(r, c));
      text += "]";
    }
    return text + "]";
  }

  Layer coverage() const {
    Layer l = layer(LayerKind::coverage, "Where each survey looked", LayerGeometry::polygon);
    l.columns = {text_column("inventory", "name of the inventory"), real_column("area_ha", 4, "area, ha"), text_column("source", "stems, frames, drawn")};
    for (const CoverageRow& row : tables_.coverages) {
      LayerFeature f;
      f.values = {LayerValue(name(row.inventory)), LayerValue(row.area_sq_m / 1e4), LayerValue(to_string(row.source))};
      for (const Eigen::Vector2d& corner : row.in_reference.corners_m) {
        if (const auto p = frame_.target_from_reference({corner.x(), corner.y(), 0.0})) f.corners.push_back({p->x(), p->y(), unknown_height});
      }
      if (f.corners.size() >= 3) l.features.push_back(std::move(f));
    }
    return l;
  }

  const ProjectState& state_;
  const Tables& tables_;
  const EarthFrame& frame_;
};

}  // namespace

const char* to_string(LayerKind kind) { return layer_words[static_cast<std::size_t>(kind)]; }

std::optional<LayerKind> layer_kind_from(std::string_view word) {
  for (std::size_t i = 0; i < layer_words.size(); ++i) {
    if (word == layer_words[i]) return static_cast<LayerKind>(i);
  }
  return std::nullopt;
}

Layer project_layer(LayerKind kind, const ProjectState& state, const Tables& tables, const EarthFrame& frame) {
  return LayerMaker(state, tables, frame).make(kind);
}

std::vector<Layer> project_layers(const ProjectState& state, const Tables& tables, const EarthFrame& frame) {
  std::vector<Layer> layers;
  for (std::size_t i = 0; i < layer_kind_count; ++i) layers.push_back(project_layer(static_cast<LayerKind>(i), state, tables, frame));
  return layers;
}

}  // namespace stemwise
