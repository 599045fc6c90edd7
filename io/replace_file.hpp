#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace stemwise {

/// Why `path` cannot be written, in words for a person: a folder that is not there is named, whatever the system said (`why`).
Issue cannot_write(const std::string& path, const std::string& why);

/// A name beside `path` for a file that is being written; same folder, so that the rename is atomic. Keeps the suffix.
std::string temporary_beside(const std::string& path);

/// Flushes `temporary` to the disk and puts it in the place of `path` in one step. On failure `path` is as it was and
/// `temporary` is gone.
Result<Done> replace_file(const std::string& temporary, const std::string& path);

/// The same, where `look` agrees with what is there just before; nobody else who replaces it in this way does so in between.
Result<Done> replace_file(const std::string& temporary, const std::string& path, const std::function<Result<Done>()>& look);

/// Writes a whole file under the name `temporary_beside(path)` and flushes it to the disk. On failure nothing of it stays.
Result<Done> write_temporary(const std::string& path, std::string_view text);

/// Writes a whole text file and puts it in the place of `path`.
Result<Done> write_text_file(const std::string& path, std::string_view text);

/// Seconds since 1970 for time stamps in files: SOURCE_DATE_EPOCH where that is set, else now.
long long timestamp_s();
/// "2026-11-22T10:15:00Z" of it.
std::string timestamp_utc();
/// "2026-11-22T10:15:00.000Z", as GeoPackages have it.
std::string timestamp_utc_ms();

}  // namespace stemwise
