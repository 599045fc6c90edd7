#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/project/project_state.hpp"

namespace stemwise {

// What is shown, exported and reported, derived from the project in one place, so that every number is the same
// everywhere. Positions in the reference's frame, metres; DBH in metres. Source of the columns: cli.md.

enum class ChangeClass { grew, shrank, within_error, unknown };
const char* to_string(ChangeClass change);

/// One stem of one inventory. Those of inventories that have no pose are not here.
struct ObservationRow {
  TreeId tree;
  StemRef stem;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  bool has_z = false;
  std::optional<double> dbh_m;
  std::optional<double> dbh_error_m;   ///< of the inventory
  Fate fate = Fate::unresolved;        ///< from this survey to the next one; of the last survey: from the one before
  std::optional<Fate> arrival;         ///< from the survey before to this one; nothing in the first survey
  std::optional<double> residual_m;    ///< planar distance to the tree's fused position, where seen twice
  std::optional<double> confidence;
  std::vector<std::string> flags;
};

/// One tree and two consecutive sightings of it (by date), or a pair that a person rejected.
struct MatchRow {
  TreeId tree;
  StemRef a;  ///< the earlier
  StemRef b;
  double distance_m = 0.0;
  std::optional<double> dbh_a_m, dbh_b_m;
  std::optional<double> change_m;  ///< of a tree alive at both: what a dead stem measures is no growth
  std::optional<double> years, growth_m_per_year;
  ChangeClass change = ChangeClass::unknown;
  double confidence = 0.0;
  MatchState state = MatchState::automatic;
  std::optional<double> second_distance_m;
  std::vector<std::string> flags;
};

/// One merged tree.
struct TreeRow {
  TreeId tree;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  bool has_z = false;
  double position_sd_m = 0.0;
  std::optional<double> dbh_m;         ///< by the fusion policy
  InventoryId dbh_source;
  std::optional<Eigen::Vector3d> axis; ///< in the reference's frame
  std::string species;
  Fate fate = Fate::unresolved;        ///< between the last two inventories by date
  InventoryId first_seen, last_seen;
  int times_seen = 0;                  ///< surveys
  std::vector<std::optional<double>> dbh_per_inventory_m;  ///< in the order of Tables::inventories
  std::optional<double> growth_m_per_year;                 ///< first to last measured DBH
  InventoryId growth_from, growth_to;                      ///< the surveys of these two, where there are two
  ChangeClass growth = ChangeClass::unknown;               ///< of the change between them
  double confidence = 1.0;             ///< of its weakest match
  std::vector<std::string> flags;
  std::string note, edited_by;
};

/// DBH change of all matched stems between two surveys.
struct GrowthRow {
  InventoryId from, to;
  std::optional<double> years;
  int n = 0;
  double median_change_m = 0.0;
  std::array<double, 2> ci95_m{};      ///< of the true median (median_interval)
  std::array<double, 2> p20_p80_m{};   ///< method.md 9, "temporal analysis"
  double dbh_error_m = 0.0;            ///< one measurement's error, robust, from the matched stems
};

struct CoverageRow {
  InventoryId inventory;
  Polygon in_reference;
  double area_sq_m = 0.0;
  CoverageSource source = CoverageSource::stems;
};

/// One doubtful case, with its reason in words.
struct QueueRow {
  TreeId tree;
  std::optional<std::size_t> match;  ///< index into Tables::matches
  double doubt = 0.0;                ///< 0..1
  std::string why;                   ///< "second candidate 0.31 m away"
  bool decided = false;
};

struct Tables {
  std::vector<InventoryId> inventories;  ///< placed ones, by date
  std::vector<ObservationRow> observations;
  std::vector<MatchRow> matches;
  std::vector<TreeRow> trees;            ///< ascending by id
  std::vector<GrowthRow> growth;
  std::vector<CoverageRow> coverages;
  std::vector<QueueRow> queue;           ///< most doubtful first
  std::array<int, fate_count> trees_by_fate{};

  const TreeRow* find(TreeId id) const;
};

/// "T-01482".
std::string tree_label(TreeId id);
Tables derive_tables(const ProjectState& state);

}  // namespace stemwise
