#pragma once
#include "core/survey/tables.hpp"

namespace stemwise {

/// Orders what a person should look at by doubt, with the reason in words (product.md, "review queue"). Needs the matches
/// and trees of `tables` in place.
std::vector<QueueRow> review_queue(const ProjectState& state, const Tables& tables);

}  // namespace stemwise
