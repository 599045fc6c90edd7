#include "io/underlay/ply_header.hpp"

#include <sstream>
#include <string>

namespace stemwise {
namespace {

constexpr int most_header_lines = 1000;

std::uint64_t bytes_of(const std::string& type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  if (type == "double" || type == "float64") return 8;
  return 4;
}

}  // namespace

std::optional<PlyHeader> read_ply_header(std::istream& in) {
  PlyHeader header;
  std::string line, element;
  bool has_position = false;
  if (!std::getline(in, line) || !line.starts_with("ply")) return std::nullopt;
  for (int i = 0; i < most_header_lines && std::getline(in, line); ++i) {
    std::istringstream words(line);
    std::string word, type, name;
    words >> word;
    if (word == "format" && words >> type) header.is_text = type == "ascii";
    if (word == "element" && words >> element && element == "vertex" && !(words >> header.vertices)) return std::nullopt;
    if (word == "property" && element == "vertex" && words >> type >> name) {
      ++header.properties;
      header.bytes_per_vertex += type == "list" ? 0 : bytes_of(type);
      has_position |= name == "x";
    }
    if (word != "end_header") continue;
    header.header_bytes = static_cast<std::uint64_t>(in.tellg());
    return has_position ? std::optional(header) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace stemwise
