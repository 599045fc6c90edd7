#pragma once
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace stemwise {

/// A text file as UTF-8 without a byte-order mark.
struct TextFile {
  std::string text;
  std::string encoding;  ///< "UTF-8", "UTF-8 with BOM", "UTF-16", "Windows-1252"
};

/// Reads a text file that is UTF-8, UTF-16 with a mark, or else taken for Windows-1252. Failure when it cannot be read, is
/// empty, or is no text.
Result<TextFile> read_text_file(const std::string& path);

bool is_valid_utf8(std::string_view text);
std::string utf8_from_windows_1252(std::string_view text);
void append_utf8(std::string& text, char32_t code_point);

}  // namespace stemwise
