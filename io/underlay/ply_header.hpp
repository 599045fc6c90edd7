#pragma once
#include <cstdint>
#include <istream>
#include <optional>

namespace stemwise {

/// What the head of a PLY file promises, to be checked before anybody makes room for it.
struct PlyHeader {
  bool is_text = false;
  std::uint64_t vertices = 0;
  std::uint64_t bytes_per_vertex = 0;  ///< in memory and in a binary file; lists not counted
  std::uint64_t properties = 0;
  std::uint64_t header_bytes = 0;
};

/// Nothing where it is no PLY file with vertices.
std::optional<PlyHeader> read_ply_header(std::istream& in);

}  // namespace stemwise
