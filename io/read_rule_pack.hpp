#pragma once
#include <string>

#include "core/survey/rule_pack.hpp"

namespace stemwise {

/// A person's own rules: JSON {"name": "stand 14", "rules": [{"flag": "too_fast", "growth_above_cm_per_year": 3, ...}]} with the
/// keys of rule_from_text; species and not_species are lists. An error issue for every rule that cannot be read.
Result<RulePack> read_rule_pack(const std::string& path);

}  // namespace stemwise
