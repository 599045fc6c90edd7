#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/project/command.hpp"
#include "core/survey/alignment.hpp"

namespace stemwise {

// Makers of every command there is. The classes behind them are private to their files (one per verb).

/// `inventory.id` is given by the project on apply (next_inventory); a name that is taken gets "-2", "-3", ...
/// The first inventory, or one with more trees than the reference while nothing is aligned, becomes the reference.
CommandPtr add_inventory(Inventory inventory);
CommandPtr remove_inventory(InventoryId id);
CommandPtr rename_inventory(InventoryId id, std::string name);
CommandPtr set_inventory_date(InventoryId id, std::optional<Date> date);
/// The stems, frames and source of the inventory with that id, made anew; its name and date stay as they are in the project.
/// Forgets what was said of its stems: matches, places in trees, an estimated coverage.
CommandPtr replace_inventory(std::shared_ptr<const Inventory> inventory);
/// A placed one: everything keeps its place (change_reference). Another one: alignments, automatic matches and the georeference
/// are forgotten.
CommandPtr set_reference(InventoryId id);
/// Takes the result of align_surveys: poses, pairs and automatic matches replace the earlier ones, decisions by hand stay
/// (linked stays linked, rejected stays rejected), tree ids stay wherever a tree keeps one of its stems.
CommandPtr apply_alignment(SurveyAlignment result, std::vector<std::pair<InventoryId, Coverage>> coverages);

CommandPtr accept_match(StemRef a, StemRef b, EditStamp stamp);
CommandPtr reject_match(StemRef a, StemRef b, EditStamp stamp);  ///< the two are different trees, also in later runs
/// The two are one tree: joins their trees; whatever other stem of the same inventory stood there is unlinked (rejected).
CommandPtr link_stems(StemRef a, StemRef b, EditStamp stamp);
/// Takes the stem out of its tree; it becomes a tree of its own, and its matches are rejected.
CommandPtr unlink_stem(StemRef stem, EditStamp stamp);
CommandPtr set_fate(TreeId tree, std::optional<Fate> fate, EditStamp stamp);
/// A sentence where the sightings say the opposite of what a person would mark; empty where it may be so.
std::string why_not_fate(const ProjectState& state, TreeId tree, Fate fate);
/// Writes a decision that is kept elsewhere (a position given by hand) into the edit log.
CommandPtr log_decision(std::string what, std::string before, std::string after, EditStamp stamp);
CommandPtr set_tree_note(TreeId tree, std::string note, EditStamp stamp);

CommandPtr set_georeference(Georeference georeference);
CommandPtr set_fusion_policy(FusionPolicy policy);
CommandPtr set_coverage(InventoryId id, Coverage coverage);
CommandPtr set_dbh_error(InventoryId id, std::optional<double> error_m);
CommandPtr set_setting(std::string key, std::string value);
CommandPtr set_title(std::string title);
/// Several as one; reverted in reverse, rolled back when one throws.
CommandPtr group(std::string label, std::vector<CommandPtr> commands);

}  // namespace stemwise
