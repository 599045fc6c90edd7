#include "io/text_file.hpp"

#include <array>
#include <filesystem>

#include "io/read_whole_file.hpp"

namespace stemwise {
namespace {

/// Code points of the bytes 0x80..0x9F in Windows-1252 (0: none, kept as a replacement character).
constexpr std::array<char32_t, 32> windows_1252_high = {
    0x20AC, 0, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0, 0x017D, 0,
    0, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0, 0x017E, 0x0178};

std::string utf8_from_utf16(std::string_view bytes, bool big_endian) {
  const auto unit = [&](std::size_t i) {
    const auto a = static_cast<unsigned char>(bytes[i]);
    const auto b = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<char32_t>(big_endian ? a << 8 | b : b << 8 | a);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    char32_t code = unit(i);
    if (code >= 0xD800 && code < 0xDC00 && i + 3 < bytes.size()) {
      code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
      i += 2;
    }
    append_utf8(text, code);
  }
  return text;
}

/// Length of the UTF-8 sequence that starts at `i`, 0 when it is none.
std::size_t sequence_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned lead = byte(i);
  const std::size_t length = lead < 0x80 ? 1 : lead >= 0xC2 && lead < 0xE0 ? 2 : lead >= 0xE0 && lead < 0xF0 ? 3 : lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
  if (length == 0 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(i + k) & 0xC0U) != 0x80) return 0;
  }
  return length;
}

TextFile decoded(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) {
    bytes.remove_prefix(3);
    if (is_valid_utf8(bytes)) return {std::string(bytes), "UTF-8 with BOM"};
    return {utf8_from_windows_1252(bytes), "Windows-1252"};
  }
  if (bytes.starts_with("\xFF\xFE")) return {utf8_from_utf16(bytes.substr(2), false), "UTF-16"};
  if (bytes.starts_with("\xFE\xFF")) return {utf8_from_utf16(bytes.substr(2), true), "UTF-16"};
  if (is_valid_utf8(bytes)) return {std::string(bytes), "UTF-8"};
  return {utf8_from_windows_1252(bytes), "Windows-1252"};
}

Issue file_issue(const std::string& path, std::string text, std::string help) {
  return {Severity::error, path, 0, {}, std::move(text), std::move(help)};
}

}  // namespace

void append_utf8(std::string& text, char32_t code) {
  const auto put = [&text](char32_t byte) { text.push_back(static_cast<char>(static_cast<unsigned char>(byte))); };
  if (code < 0x80) return put(code);
  if (code < 0x800) {
    put(0xC0 | code >> 6);
  } else if (code < 0x10000) {
    put(0xE0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3F));
  } else {
    put(0xF0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3F));
    put(0x80 | (code >> 6 & 0x3F));
  }
  put(0x80 | (code & 0x3F));
}

bool is_valid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

std::string utf8_from_windows_1252(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    char32_t code = byte;
    if (byte >= 0x80 && byte < 0xA0) {
      const char32_t high = windows_1252_high[byte - 0x80];
      code = high != 0 ? high : 0xFFFD;
    }
    append_utf8(text, code);
  }
  return text;
}

Result<TextFile> read_text_file(const std::string& path) {
  const auto bytes = read_whole_file(path);
  if (!bytes) return Result<TextFile>::failure(file_issue(path, "cannot be read", "check that it is there and that you may read it"));
  TextFile file = decoded(bytes->text());
  if (file.text.find_first_not_of(" \t\r\n") == std::string::npos) {
    return Result<TextFile>::failure(file_issue(path, "is empty", "export the stem list again"));
  }
  if (file.text.find('\0') != std::string::npos) {
    return Result<TextFile>::failure(file_issue(path, "is not a text file", "save the stem list as CSV, XLSX, GeoPackage or Shapefile"));
  }
  return file;
}

}  // namespace stemwise
