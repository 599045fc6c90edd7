#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace stemwise {

/// A file's bytes in one allocation that is not cleared first. Behind them lies a line end, so that a parser need not look
/// for the end of the text at every character, and behind that eight bytes more, so that it may look at eight at once.
struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;
  std::string_view text() const { return {data.get(), size}; }
};

/// One open, one allocation, one read: what counts when there are thousands of small files. Nothing when it cannot be read.
std::optional<FileBytes> read_whole_file(const std::string& path);

}  // namespace stemwise
