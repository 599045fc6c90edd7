#pragma once
#include <bit>
#include <cstddef>
#include <cstring>

namespace stemwise {

static_assert(std::endian::native == std::endian::little, "records are copied as they lie in the file");

/// A number that lies anywhere in a record, least significant byte first.
template <class Value>
Value number_at(const char* record, std::size_t at) {
  Value value;
  std::memcpy(&value, record + at, sizeof value);
  return value;
}

}  // namespace stemwise
