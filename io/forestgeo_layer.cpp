#include "io/forestgeo_layer.hpp"

#include <cmath>
#include <limits>
#include <map>

namespace stemwise {
namespace {

LayerColumn text_column(const char* name, const char* description) { return {name, ColumnType::text, 0, description}; }

std::vector<LayerColumn> columns() {
  return {{"treeID", ColumnType::integer, 0, "number of the tree, the same in every census"},
          {"stemID", ColumnType::integer, 0, "number of the stem; here that of its tree"},
          text_column("tag", "label of the tree"),
          text_column("StemTag", "id of the stem in the file that was read"),
          text_column("sp", "species as the file names it"),
          text_column("quadrat", "20 m quadrat, column and row from the south-west corner"),
          {"gx", ColumnType::real, 3, "m east (frame x) of the south-west corner"},
          {"gy", ColumnType::real, 3, "m north (frame y) of the south-west corner"},
          {"dbh", ColumnType::real, 1, "diameter at breast height, mm"},
          {"hom", ColumnType::real, 2, "height of measurement, m"},
          text_column("ExactDate", "day of the measurement"),
          text_column("CensusID", "inventory"),
          text_column("status", "A alive, D dead, M missing inside coverage"),
          text_column("codes", "Stemwise's fate and flags")};
}

std::string quadrat(double gx, double gy) {
  const auto two = [](double v) { const int n = static_cast<int>(v / 20.0); return (n < 10 ? "0" : "") + std::to_string(n); };
  return two(gx) + two(gy);
}

class ForestGeo {
 public:
  ForestGeo(const ProjectState& state, const Tables& tables) : state_(state), tables_(tables) {
    for (std::size_t i = 0; i < tables.inventories.size(); ++i) census_[tables.inventories[i]] = i;
    for (const ObservationRow& row : tables.observations) seen_[row.tree].push_back(&row);
    corner_m_.setConstant(std::numeric_limits<double>::max());
    for (const TreeRow& tree : tables.trees) corner_m_ = corner_m_.cwiseMin(tree.position_m.head<2>());
    corner_m_ = corner_m_.array().floor();
  }

  Layer run() {
    Layer layer;
    layer.name = "forestgeo";
    layer.title = "Censuses as ForestGEO tables have them";
    layer.columns = columns();
    for (std::size_t census = 0; census < tables_.inventories.size(); ++census)
      for (const TreeRow& tree : tables_.trees)
        if (auto row = row_of(tree, census)) layer.features.push_back({std::move(*row), {}});
    return layer;
  }

 private:
  /// Nothing before the tree was first seen, and where the census did not look.
  std::optional<std::vector<LayerValue>> row_of(const TreeRow& tree, std::size_t census) const {
    const ObservationRow* before = nullptr;
    for (const ObservationRow* row : seen_.at(tree.tree)) {
      const std::size_t at = census_.at(row->stem.inventory);
      if (at == census) {
        const Stem& stem = *state_.find(row->stem);
        return cells(tree, census, stem.source_id, row->dbh_m, stem.date, is_living(stem.status) ? "A" : "D", to_string(row->fate));
      }
      if (at < census) before = row;
    }
    if (before == nullptr) return std::nullopt;
    const bool is_dead = before->fate == Fate::dead || before->fate == Fate::removed;
    if (!is_dead && before->fate != Fate::missing) return std::nullopt;
    return cells(tree, census, "", std::nullopt, std::nullopt, is_dead ? "D" : "M", to_string(before->fate));
  }

  std::vector<LayerValue> cells(const TreeRow& tree, std::size_t census, const std::string& source_id, std::optional<double> dbh_m, std::optional<Date> date, const char* status,
                                const std::string& fate) const {
    const Inventory& inventory = *state_.find(tables_.inventories[census]);
    if (!date) date = inventory.date;
    const Eigen::Vector2d at = tree.position_m.head<2>() - corner_m_;
    std::string codes = fate;
    for (const std::string& flag : tree.flags) codes += ";" + flag;
    return {LayerValue(tree.tree.value), LayerValue(tree.tree.value), LayerValue(tree_label(tree.tree)), LayerValue(source_id), LayerValue(tree.species), LayerValue(quadrat(at.x(), at.y())),
            LayerValue(at.x()), LayerValue(at.y()), dbh_m ? LayerValue(1000.0 * *dbh_m) : LayerValue(), dbh_m ? LayerValue(1.3) : LayerValue(),
            date ? LayerValue(to_string(*date)) : LayerValue(), LayerValue(inventory.name), LayerValue(status), LayerValue(codes)};
  }

  const ProjectState& state_;
  const Tables& tables_;
  std::map<InventoryId, std::size_t> census_;
  std::map<TreeId, std::vector<const ObservationRow*>> seen_;
  Eigen::Vector2d corner_m_;
};

}  // namespace

Layer forestgeo_layer(const ProjectState& state, const Tables& tables) { return ForestGeo(state, tables).run(); }

}  // namespace stemwise
