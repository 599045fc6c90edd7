#pragma once
#include "core/project/project_state.hpp"

namespace stemwise {

/// A small project that has something in every field: three surveys, one unaligned, matches of every state, an anchor at
/// Brisbane (UTM 56 south), awkward doubles and texts.
ProjectState sample_project();

/// `surveys` surveys of `stems` trees each, all matched in a chain.
ProjectState large_project(int stems, int surveys);

}  // namespace stemwise
