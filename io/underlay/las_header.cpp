#include "io/underlay/las_header.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "io/underlay/little_endian.hpp"

namespace stemwise {
namespace {

constexpr std::size_t oldest_header_bytes = 227;  // LAS 1.0 to 1.2
constexpr std::size_t newest_header_bytes = 375;  // LAS 1.4
constexpr std::size_t record_header_bytes = 54;
constexpr std::uint32_t most_variable_records = 10'000;
constexpr std::array<std::uint32_t, 11> bytes_of_format{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
constexpr std::array<std::uint32_t, 11> colour_of_format{0, 0, 20, 28, 0, 28, 0, 30, 30, 0, 30};

Result<LasHeader> refuse(const std::string& path, std::string text, std::string help) {
  return Result<LasHeader>::failure(Issue{Severity::error, path, 0, {}, std::move(text), std::move(help)});
}

/// "EPSG:25832" of a GeoTIFF key directory; empty where it names a system of its own or none.
std::string system_of_keys(const std::vector<char>& keys) {
  constexpr std::uint16_t geographic = 2048, projected = 3072, user_defined = 32767;
  std::string found;
  for (std::size_t at = 8; at + 8 <= keys.size(); at += 8) {
    const auto key = number_at<std::uint16_t>(keys.data(), at), location = number_at<std::uint16_t>(keys.data(), at + 2);
    const auto value = number_at<std::uint16_t>(keys.data(), at + 6);
    if (location != 0 || value == 0 || value == user_defined) continue;
    if (key == projected) return "EPSG:" + std::to_string(value);
    if (key == geographic) found = "EPSG:" + std::to_string(value);
  }
  return found;
}

/// The coordinate system out of the variable length records behind the header.
std::string find_system(std::istream& in, std::uint64_t first_at, std::uint32_t count) {
  constexpr std::uint16_t wkt_record = 2112, keys_record = 34735;
  std::string of_keys;
  in.seekg(static_cast<std::streamoff>(first_at));
  for (std::uint32_t i = 0; i < std::min(count, most_variable_records); ++i) {
    std::array<char, record_header_bytes> head{};
    if (!in.read(head.data(), head.size())) return of_keys;
    const std::string user(head.data() + 2, std::find(head.data() + 2, head.data() + 18, '\0'));
    const auto id = number_at<std::uint16_t>(head.data(), 18), bytes = number_at<std::uint16_t>(head.data(), 20);
    std::vector<char> body(bytes);
    if (!in.read(body.data(), bytes)) return of_keys;
    if (user != "LASF_Projection") continue;
    if (id == wkt_record) {
      const std::string wkt(body.begin(), std::find(body.begin(), body.end(), '\0'));
      if (!wkt.empty()) return wkt;
    }
    if (id == keys_record) of_keys = system_of_keys(body);
  }
  return of_keys;
}

}  // namespace

std::uint32_t las_record_bytes(int point_format) { return bytes_of_format.at(static_cast<std::size_t>(point_format)); }
std::uint32_t las_colour_at(int point_format) { return colour_of_format.at(static_cast<std::size_t>(point_format)); }

Result<LasHeader> read_las_header(std::istream& in, const std::string& path) {
  const std::string damaged = "the file may be damaged or cut off: copy it again";
  std::array<char, newest_header_bytes> head{};
  in.read(head.data(), head.size());
  const auto got = static_cast<std::size_t>(in.gcount());
  in.clear();
  const char* h = head.data();
  if (got < 4 || std::string(h, 4) != "LASF") return refuse(path, "no LAS file: it does not begin with LASF", "LAS 1.0 to 1.4, PCD and PLY can be laid under the stems");
  if (got < oldest_header_bytes) return refuse(path, "it ends within its header", damaged);
  LasHeader header;
  header.minor_version = static_cast<unsigned char>(h[25]);
  if (h[24] != 1 || header.minor_version > 4)
    return refuse(path, "it is LAS " + std::to_string(int{h[24]}) + "." + std::to_string(header.minor_version) + ", which is not known here", "save it as LAS 1.4");
  const auto format = static_cast<unsigned char>(h[104]);
  header.is_compressed = (format & 0xC0) != 0;
  header.point_format = format & 0x3F;
  header.record_bytes = number_at<std::uint16_t>(h, 105);
  header.first_point_at = number_at<std::uint32_t>(h, 96);
  header.point_count = number_at<std::uint32_t>(h, 107);
  if (header.minor_version >= 4 && got >= 255) header.point_count = std::max<std::uint64_t>(header.point_count, number_at<std::uint64_t>(h, 247));
  if (header.is_compressed) return header;
  if (header.point_format > 10) return refuse(path, "its points are of format " + std::to_string(header.point_format) + ", which is not known here", "save it as LAS 1.4 with point format 6 or 7");
  bool is_sound = header.record_bytes >= las_record_bytes(header.point_format) && header.first_point_at >= oldest_header_bytes;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    header.scale[axis] = number_at<double>(h, 131 + 8 * i);
    header.offset[axis] = number_at<double>(h, 155 + 8 * i);
    header.high[axis] = number_at<double>(h, 179 + 16 * i);
    header.low[axis] = number_at<double>(h, 187 + 16 * i);
    is_sound &= std::isfinite(header.scale[axis]) && header.scale[axis] > 0.0 && std::isfinite(header.offset[axis]);
  }
  if (!is_sound) return refuse(path, "its header contradicts itself", damaged);
  header.wkt = find_system(in, number_at<std::uint16_t>(h, 94), number_at<std::uint32_t>(h, 100));
  return header;
}

}  // namespace stemwise
