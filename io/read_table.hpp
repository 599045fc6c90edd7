#pragma once
#include <string>

#include "io/stem_table.hpp"

namespace stemwise {

/// Opens a stem table of delimited text of any common kind (data-formats.md): encoding, delimiter, preamble and decimal
/// sign are recognised. Failure when no header of a stem table is found.
Result<OpenedTable> open_text_table(const std::string& path, const ReadOptions& options = {});

}  // namespace stemwise
