#include "io/project_stamp.hpp"

#include <sys/stat.h>

#include <filesystem>

#include "io/gdal_session.hpp"
#include "io/project_tables.hpp"
#include "io/read_gis.hpp"

namespace stemwise {
namespace {

std::string file_stamp(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) return "";
  return "file " + std::to_string(about.st_size) + " " + std::to_string(about.st_mtim.tv_sec) + "." + std::to_string(about.st_mtim.tv_nsec) + " " + std::to_string(about.st_ino);
}

/// "" where the file has none.
std::string written_fingerprint(const std::string& path) {
  const GdalMessages quiet;
  const DatasetPtr dataset = open_vector(path);
  if (!dataset || dataset->GetLayerByName("stemwise_project") == nullptr) return "";
  try {
    TableReader table(*dataset, "stemwise_project", project_tables::project);
    while (table.next())
      if (table.text(0) == project_tables::fingerprint_key) return table.text(1);
  } catch (const TableError&) {
    return "";  // damaged: it is a file all the same
  }
  return "";
}

}  // namespace

ProjectStamp project_stamp(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) || file_kind(path) != FileKind::sqlite) return {file_stamp(path)};
  const std::string fingerprint = written_fingerprint(path);
  return {fingerprint.empty() ? file_stamp(path) : fingerprint};
}

bool is_changed_since(const ProjectStamp& known, const std::string& path) {
  const ProjectStamp now = project_stamp(path);
  return !now.text.empty() && now != known;
}

}  // namespace stemwise
