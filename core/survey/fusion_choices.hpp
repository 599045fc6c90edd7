#pragma once
#include <map>
#include <optional>
#include <string>

#include "core/project/command.hpp"
#include "core/project/project_state.hpp"

namespace stemwise {

// The manual fusion policy: for one tree and one attribute a person names the survey whose value the merged tree takes,
// whatever the project's policy says. Kept with the project's settings ("fusion.tree.12.dbh" = the inventory's id), so that
// the file format, undo and the exports' account of settings hold it.

enum class FusedAttribute { dbh, position, species };
const char* to_string(FusedAttribute attribute);

/// What a person chose for one tree; empty: by the policy.
struct FusionChoice {
  std::optional<InventoryId> dbh, position, species;
  bool operator==(const FusionChoice&) const = default;
};

/// Takes the attribute from that survey; empty: by the policy again. A survey that has not seen the tree, or has no value,
/// changes nothing: then the policy decides.
CommandPtr choose_source(TreeId tree, FusedAttribute attribute, std::optional<InventoryId> source);

/// All choices of a project.
std::map<TreeId, FusionChoice> fusion_choices(const ProjectState& state);
/// Whether a setting is such a choice.
bool is_fusion_choice(const std::string& key);

}  // namespace stemwise
