#pragma once
#include "core/survey/tables.hpp"

namespace stemwise {

/// What a row of the queue is in doubt about: for filters.
enum class DoubtKind { second_candidate, shrank, grew, residual, species, confidence, missing, edge, missed_earlier, other };
inline constexpr std::size_t doubt_kind_count = 10;
const char* doubt_label(DoubtKind kind);  ///< "Second candidate", for people
/// By the row's reason; `other` for one that a person gave.
DoubtKind kind_of(const QueueRow& row);

/// Orders what a person should look at by doubt, with the reason in words (product.md, "review queue"): one undecided row per
/// tree at most, and behind them every decision made by hand. Needs the matches and trees of `tables` in place.
std::vector<QueueRow> review_queue(const ProjectState& state, const Tables& tables);

}  // namespace stemwise
