#include "core/survey/fusion_review.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <unordered_map>

#include "core/survey/fusion_choices.hpp"

namespace stemwise {
namespace {

using Rows = std::vector<const ObservationRow*>;  // of one tree, by survey in time

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string number(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// Rows and broken flags of every tree.
struct Evidence {
  std::map<TreeId, Rows> rows;
  std::set<TreeId> dbh, status;
};

Evidence collect(const Tables& tables) {
  Evidence evidence;
  for (const ObservationRow& row : tables.observations) evidence.rows[row.tree].push_back(&row);
  for (const MatchRow& match : tables.matches) {
    if (match.state == MatchState::rejected) continue;
    for (const std::string& flag : match.flags) {
      if (flag == "shrinkage" || flag == "implausible_growth") evidence.dbh.insert(match.tree);
      if (flag == "alive_after_dead") evidence.status.insert(match.tree);
    }
  }
  return evidence;
}

double noise_m(const ProjectState& state, InventoryId id) {
  const auto found = state.alignments.find(id);
  return found == state.alignments.end() ? 0.1 : std::max(0.1, found->second.position_noise_m);
}

class Review {
 public:
  Review(const ProjectState& state, const Tables& tables) : state_(state), tables_(tables), evidence_(collect(tables)), choices_(fusion_choices(state)) {}

  std::vector<FusionConflict> run() {
    for (const TreeRow& tree : tables_.trees) {
      const auto rows = evidence_.rows.find(tree.tree);
      if (rows == evidence_.rows.end() || rows->second.size() < 2) continue;
      species(tree, rows->second);
      if (evidence_.dbh.contains(tree.tree)) diameters(tree, rows->second);
      position(tree, rows->second);
      if (evidence_.status.contains(tree.tree)) status(tree, rows->second);
    }
    return std::move(conflicts_);
  }

 private:
  const Stem& stem(const ObservationRow& row) const { return *state_.find(row.stem); }
  FusionChoice choice(TreeId tree) const {
    const auto found = choices_.find(tree);
    return found == choices_.end() ? FusionChoice{} : found->second;
  }

  void species(const TreeRow& tree, const Rows& rows) {
    FusionConflict conflict{tree.tree, "species", {}, tree.species, {}, choice(tree.tree).species.has_value()};
    std::set<std::string> names;
    for (const ObservationRow* row : rows) {
      const std::string& name = stem(*row).species;
      if (name.empty()) continue;
      names.insert(lower(name));
      conflict.values.emplace_back(row->stem.inventory, name);
      if (name == tree.species) conflict.source = row->stem.inventory;
    }
    if (names.size() > 1) conflicts_.push_back(std::move(conflict));
  }

  void diameters(const TreeRow& tree, const Rows& rows) {
    FusionConflict conflict{tree.tree, "dbh", {}, tree.dbh_m ? number(*tree.dbh_m * 100.0, 1) : "", tree.dbh_source, choice(tree.tree).dbh.has_value()};
    for (const ObservationRow* row : rows)
      if (row->dbh_m) conflict.values.emplace_back(row->stem.inventory, number(*row->dbh_m * 100.0, 1));
    conflicts_.push_back(std::move(conflict));
  }

  void position(const TreeRow& tree, const Rows& rows) {
    const bool far = std::any_of(rows.begin(), rows.end(), [&](const ObservationRow* row) {
      return row->residual_m && *row->residual_m > std::max(1.0, 4.0 * noise_m(state_, row->stem.inventory));
    });
    if (!far) return;
    const FusionChoice chosen = choice(tree.tree);
    FusionConflict conflict{tree.tree, "position", {}, number(tree.position_m.x(), 2) + ", " + number(tree.position_m.y(), 2), chosen.position.value_or(InventoryId{}),
                            chosen.position.has_value()};
    for (const ObservationRow* row : rows) conflict.values.emplace_back(row->stem.inventory, number(row->residual_m.value_or(0.0), 2) + " m off");
    conflicts_.push_back(std::move(conflict));
  }

  void status(const TreeRow& tree, const Rows& rows) {
    FusionConflict conflict{tree.tree, "status", {}, to_string(tree.fate), {}, false};
    for (const ObservationRow* row : rows) conflict.values.emplace_back(row->stem.inventory, is_living(stem(*row).status) ? "alive" : to_string(stem(*row).status));
    conflicts_.push_back(std::move(conflict));
  }

  const ProjectState& state_;
  const Tables& tables_;
  Evidence evidence_;
  std::map<TreeId, FusionChoice> choices_;
  std::vector<FusionConflict> conflicts_;
};

struct Bounds {
  Eigen::Vector2d low, high;
};

std::optional<Bounds> bounds_of(const Tables& tables) {
  std::optional<Bounds> bounds;
  for (const CoverageRow& row : tables.coverages)
    for (const Eigen::Vector2d& corner : row.in_reference.corners_m) {
      if (!bounds) bounds = Bounds{corner, corner};
      bounds->low = bounds->low.cwiseMin(corner), bounds->high = bounds->high.cwiseMax(corner);
    }
  return bounds;
}

}  // namespace

std::vector<FusionConflict> fusion_conflicts(const ProjectState& state, const Tables& tables) { return Review(state, tables).run(); }

ObservedGround observed_ground(const Tables& tables) {
  constexpr double well_seen = 0.6, most_squares = 250'000.0;
  ObservedGround ground;
  const auto bounds = bounds_of(tables);
  if (!bounds) return ground;
  const Eigen::Vector2d size = bounds->high - bounds->low;
  ground.square_m = std::max(ground.square_m, std::sqrt(size.x() * size.y() / most_squares));
  const auto columns = static_cast<std::size_t>(size.x() / ground.square_m) + 1, rows = static_cast<std::size_t>(size.y() / ground.square_m) + 1;
  std::vector<ObservedSquare> squares(columns * rows);
  for (std::size_t k = 0; k < squares.size(); ++k) {
    squares[k].centre_m = bounds->low + ground.square_m * Eigen::Vector2d(static_cast<double>(k % columns) + 0.5, static_cast<double>(k / columns) + 0.5);
    for (const CoverageRow& row : tables.coverages) squares[k].surveys += contains(row.in_reference, squares[k].centre_m) ? 1 : 0;
  }
  for (const TreeRow& tree : tables.trees) {
    const Eigen::Vector2d at = (tree.position_m.head<2>() - bounds->low) / ground.square_m;
    if (at.x() < 0.0 || at.y() < 0.0 || at.x() >= static_cast<double>(columns) || at.y() >= static_cast<double>(rows)) continue;
    ObservedSquare& square = squares[static_cast<std::size_t>(at.y()) * columns + static_cast<std::size_t>(at.x())];
    ++square.trees;
    square.seen_share += tree.times_seen;
  }
  ground.ha_by_surveys.assign(tables.coverages.size(), 0.0);
  for (ObservedSquare& square : squares) {
    if (square.surveys == 0) continue;
    ground.ha_by_surveys[static_cast<std::size_t>(square.surveys) - 1] += ground.square_m * ground.square_m / 10'000.0;
    square.seen_share = square.trees == 0 ? 0.0 : std::min(1.0, square.seen_share / (square.trees * square.surveys));
    const bool all = square.surveys == static_cast<int>(tables.coverages.size());
    if (!all || (square.trees > 2 && square.seen_share < well_seen)) ground.under_observed.push_back(square);
  }
  std::stable_sort(ground.under_observed.begin(), ground.under_observed.end(), [](const ObservedSquare& a, const ObservedSquare& b) {
    return a.surveys != b.surveys ? a.surveys < b.surveys : a.seen_share < b.seen_share;
  });
  return ground;
}

}  // namespace stemwise
