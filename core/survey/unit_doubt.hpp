#pragma once
#include <string>
#include <vector>

#include "core/project/project_state.hpp"

namespace stemwise {

/// Sentences about pairs of surveys whose matched stems' diameters are as a whole far apart (median ratio below 0.6 or above
/// 1.7, eight pairs or more), as no forest grows: one of them was read in a wrong unit, or is not a diameter. Surveys in the
/// order of their dates; empty when nothing is strange.
std::vector<std::string> unit_doubts(const ProjectState& state);

}  // namespace stemwise
