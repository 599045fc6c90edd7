#pragma once
#include <string>

#include "app/read_overrides.hpp"
#include "app/session.hpp"

namespace stemwise {

struct ConvertOptions {
  std::string input;
  std::string output;
  ReadOverrides read;
};

/// `stemwise convert IN -o OUT`: one inventory format to another; frames become one stem list unless OUT is a folder.
ExitCode run_convert(const ConvertOptions& options, Session& session);

}  // namespace stemwise
