#pragma once
#include <optional>
#include <string>

#include "io/stem_table.hpp"

namespace stemwise {

/// Opens the stem table in a file, whatever its kind (text, workbook, GIS points), recognised by its content. Nothing for
/// files of no kind that holds tables; a failure, with what helps, where there is none inside.
std::optional<Result<OpenedTable>> open_table(const std::string& path, const ReadOptions& options);

}  // namespace stemwise
