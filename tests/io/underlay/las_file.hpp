#pragma once
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace stemwise::test {

/// A LAS file, byte by byte.
struct LasFile {
  int minor = 2;
  int format = 1;
  std::vector<char> variable_records;
  std::uint32_t variable_record_count = 0;
  std::vector<std::vector<char>> points;

  static constexpr std::uint16_t record_bytes[11] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

  template <class Value>
  static void put(std::vector<char>& bytes, std::size_t at, Value value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
  }

  /// Coordinates in mm from 500000, 5400000, 0.
  void add(double x, double y, double z, std::uint16_t intensity, unsigned char kind, std::uint16_t red = 0) {
    std::vector<char> p(record_bytes[format], 0);
    put(p, 0, static_cast<std::int32_t>((x - 500000.0) * 1000.0));
    put(p, 4, static_cast<std::int32_t>((y - 5400000.0) * 1000.0));
    put(p, 8, static_cast<std::int32_t>(z * 1000.0));
    put(p, 12, intensity);
    p[format >= 6 ? 16 : 15] = static_cast<char>(kind);
    const std::size_t colour_at[11] = {0, 0, 20, 28, 0, 28, 0, 30, 30, 0, 30};
    if (colour_at[format] != 0) put(p, colour_at[format], red);
    points.push_back(std::move(p));
  }

  void add_variable_record(const char* user, std::uint16_t id, const std::vector<char>& body) {
    std::vector<char> head(54, 0);
    std::strncpy(head.data() + 2, user, 16);
    put(head, 18, id);
    put(head, 20, static_cast<std::uint16_t>(body.size()));
    variable_records.insert(variable_records.end(), head.begin(), head.end());
    variable_records.insert(variable_records.end(), body.begin(), body.end());
    ++variable_record_count;
  }

  /// ProjectedCSTypeGeoKey.
  void name_system(std::uint16_t epsg) {
    const std::uint16_t keys[8] = {1, 1, 0, 1, 3072, 0, 1, epsg};
    std::vector<char> body(sizeof keys);
    std::memcpy(body.data(), keys, sizeof keys);
    add_variable_record("LASF_Projection", 34735, body);
  }

  std::vector<char> bytes() const {
    const std::uint16_t header_bytes = minor >= 4 ? 375 : minor == 3 ? 235 : 227;
    std::vector<char> all(header_bytes, 0);
    std::memcpy(all.data(), "LASF", 4);
    all[24] = 1;
    all[25] = static_cast<char>(minor);
    put(all, 94, header_bytes);
    put(all, 96, static_cast<std::uint32_t>(header_bytes + variable_records.size()));
    put(all, 100, variable_record_count);
    all[104] = static_cast<char>(format);
    put(all, 105, record_bytes[format]);
    if (minor < 4) put(all, 107, static_cast<std::uint32_t>(points.size()));
    if (minor >= 4) put(all, 247, static_cast<std::uint64_t>(points.size()));
    for (std::size_t axis = 0; axis < 3; ++axis) put(all, 131 + 8 * axis, 0.001);
    put(all, 155, 500000.0);
    put(all, 163, 5400000.0);
    all.insert(all.end(), variable_records.begin(), variable_records.end());
    for (const auto& p : points) all.insert(all.end(), p.begin(), p.end());
    return all;
  }

  void write(const std::string& path) const {
    const std::vector<char> all = bytes();
    std::ofstream(path, std::ios::binary).write(all.data(), static_cast<std::streamsize>(all.size()));
  }
};

}  // namespace stemwise::test
