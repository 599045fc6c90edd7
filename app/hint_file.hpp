#pragma once
#include <string>

#include "core/base/result.hpp"
#include "core/project/project_state.hpp"
#include "core/survey/align_surveys.hpp"

namespace stemwise {

/// Reads a `--hint` file (cli.md, "Files"): one object or a list of them, each with "inventory" and "pairs" (ids of the same
/// trees in the reference and in it) or "pose". Ids and names are looked up in `state`.
Result<AlignHints> read_hint_file(const std::string& path, const ProjectState& state);

}  // namespace stemwise
