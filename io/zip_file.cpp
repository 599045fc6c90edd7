#include "io/zip_file.hpp"

#include <cpl_conv.h>

#include <filesystem>

#include "io/gdal_session.hpp"
#include "io/replace_file.hpp"

namespace stemwise {

Result<Done> write_temporary_zip(const std::string& path, const std::vector<ZipEntry>& entries) {
  const GdalMessages messages;
  const std::string temporary = temporary_beside(path);
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  void* zip = CPLCreateZip(temporary.c_str(), nullptr);
  bool complete = zip != nullptr;
  for (const ZipEntry& entry : entries) {
    if (!complete) break;
    complete = CPLCreateFileInZip(zip, entry.name.c_str(), nullptr) == CE_None;
    complete = complete && CPLWriteFileInZip(zip, entry.bytes.data(), static_cast<int>(entry.bytes.size())) == CE_None;
    complete = complete && CPLCloseFileInZip(zip) == CE_None;
  }
  if (zip != nullptr) complete = CPLCloseZip(zip) == CE_None && complete;
  if (complete) return Done{};
  std::filesystem::remove(temporary, ignored);
  return Result<Done>::failure(cannot_write(path, messages.errors().empty() ? "" : messages.last_error()));
}

Result<Done> write_zip(const std::string& path, const std::vector<ZipEntry>& entries) {
  if (Result<Done> done = write_temporary_zip(path, entries); !done) return done;
  return replace_file(temporary_beside(path), path);
}

}  // namespace stemwise
