#include "io/open_table.hpp"

#include "io/read_gis.hpp"
#include "io/read_table.hpp"

namespace stemwise {

std::optional<Result<OpenedTable>> open_table(const std::string& path, const ReadOptions& options) {
  switch (file_kind(path)) {
    case FileKind::text: return open_text_table(path, options);
    case FileKind::workbook: return open_workbook(path, options);
    case FileKind::sqlite:
    case FileKind::gis: return open_gis_points(path, options);
    case FileKind::unknown_binary: break;
  }
  return std::nullopt;
}

}  // namespace stemwise
