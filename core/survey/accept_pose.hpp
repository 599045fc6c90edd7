#pragma once
#include <string>

#include "core/survey/alignment.hpp"
#include "core/survey/list_settings.hpp"

namespace stemwise {

struct Verdict {
  AlignmentStatus status = AlignmentStatus::failed;  ///< aligned, probable or failed
  std::string reason;                                ///< a sentence; empty when aligned
};

/// Step 7 of stem-lists.md: believes a pose that is far likelier than the best of all poses tried would be by chance, and
/// that leads the second best and the best of the mirror image.
Verdict accept_pose(const Acceptance& acceptance, const ListSettings& settings);

/// 1 / (1 + exp(-(Lambda - ln N))), lowered where the lead is small: a first probability for the window.
double acceptance_probability(const Acceptance& acceptance);

}  // namespace stemwise
