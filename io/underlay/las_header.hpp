#pragma once
#include <cstdint>
#include <istream>
#include <string>

#include "core/base/result.hpp"

namespace stemwise {

/// What the head of a LAS file says (ASPRS LAS 1.0 to 1.4).
struct LasHeader {
  int minor_version = 0;
  int point_format = 0;           ///< 0..10
  bool is_compressed = false;     ///< LAZ
  std::uint32_t record_bytes = 0;
  std::uint64_t first_point_at = 0;
  std::uint64_t point_count = 0;
  double scale[3] = {};
  double offset[3] = {};
  double low[3] = {}, high[3] = {};
  std::string wkt;                ///< of the coordinate system, or "EPSG:n"; empty: none is named
};

/// Also reads the variable length records that name the coordinate system. Leaves the stream anywhere.
Result<LasHeader> read_las_header(std::istream& in, const std::string& path);

/// Fewest bytes of a record of the format, and where colours are in it (0: nowhere).
std::uint32_t las_record_bytes(int point_format);
std::uint32_t las_colour_at(int point_format);

}  // namespace stemwise
