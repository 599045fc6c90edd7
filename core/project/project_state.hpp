#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/ids.hpp"
#include "core/forest/inventory.hpp"
#include "core/geodesy/georeference.hpp"
#include "core/geometry/polygon.hpp"
#include "core/survey/alignment.hpp"
#include "core/survey/fate.hpp"

namespace stemwise {

using StemPair = std::pair<StemRef, StemRef>;
/// The pair with the smaller reference first: the key of a match.
StemPair ordered(StemRef a, StemRef b);

/// One tree of the forest: the stems of all surveys that are held to be it, at most one per inventory.
struct TreeRecord {
  TreeId id;
  std::vector<StemRef> stems;         ///< ascending
  std::optional<Fate> fate_by_hand;   ///< dead, removed, ...: a person said so
  std::string note;
  std::string edited_by;
  bool operator==(const TreeRecord&) const = default;
};

enum class FusionPolicy { min_dbh, newest, best, mean };
const char* to_string(FusionPolicy policy);  ///< "min-dbh", ...
std::optional<FusionPolicy> fusion_policy_from(const std::string& word);

enum class CoverageSource { stems, frames, drawn };
const char* to_string(CoverageSource source);

/// Where a survey looked, as a polygon in that inventory's own frame.
struct Coverage {
  Polygon in_inventory;
  CoverageSource source = CoverageSource::stems;
  bool operator==(const Coverage&) const = default;
};

/// One line of the readable edit log.
struct EditLogEntry {
  std::string time_utc;  ///< "2026-11-22T10:15:00Z"
  std::string author;
  std::string what;      ///< the command's label
  std::string before;
  std::string after;
  std::string note;
  bool operator==(const EditLogEntry&) const = default;
};

/// Everything a project file holds. A plain value: a job takes a copy (inventories are shared, never changed).
/// Changed only by commands through Project::execute.
struct ProjectState {
  std::string title;
  std::vector<std::shared_ptr<const Inventory>> inventories;  ///< in the order of adding
  InventoryId reference;                                      ///< none while there is no inventory
  std::map<InventoryId, InventoryAlignment> alignments;
  std::map<InventoryId, Coverage> coverages;
  std::vector<PairReport> pairs;
  std::map<StemPair, Match> matches;           ///< keyed by the ordered pair
  std::map<TreeId, TreeRecord> trees;
  std::map<InventoryId, std::vector<TreeId>> tree_of_stem;  ///< per inventory, by stem index
  std::int64_t next_tree = 1;
  std::int64_t next_inventory = 1;
  Georeference georeference;
  FusionPolicy fusion = FusionPolicy::min_dbh;
  std::map<InventoryId, double> dbh_error_m;   ///< set by a person; estimated from the matched stems where absent
  std::map<std::string, std::string> settings; ///< by key, as --set takes them
  std::vector<EditLogEntry> edit_log;

  bool operator==(const ProjectState& o) const;

  const Inventory* find(InventoryId id) const;
  const Inventory* find(const std::string& name) const;
  const Stem* find(StemRef stem) const;
  /// Aligned, reference, or probable that was accepted: has a place in the reference's frame.
  bool is_placed(InventoryId id) const;
  RigidTransform reference_from_inventory(InventoryId id) const;  ///< identity for the reference; throws when not placed
  Eigen::Vector3d stem_in_reference_m(StemRef stem) const;        ///< z 0 when unknown
  TreeId tree_of(StemRef stem) const;                             ///< none when not associated yet
  /// Inventories ordered by date (stable; those without a date keep their place in the order given, after dated ones).
  std::vector<InventoryId> by_date() const;
};

}  // namespace stemwise
