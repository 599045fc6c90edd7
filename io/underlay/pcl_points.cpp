#include "io/underlay/pcl_points.hpp"

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>

#include "io/underlay/little_endian.hpp"
#include "io/underlay/ply_header.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t points_per_check = 16'384;

Issue error_in(const std::string& path, std::string text, std::string help) { return {Severity::error, path, 0, {}, std::move(text), std::move(help)}; }

Issue too_large(const std::string& path) {
  return error_in(path, "it is too large to be read whole", "thin it, for example with a voxel filter of 5 cm, or save it as LAS, which is thinned while reading");
}

Issue cut_off(const std::string& path, std::uint64_t points) {
  return error_in(path, "it promises " + std::to_string(points) + " points and ends before them", "the file may be cut off: copy it again");
}

/// A number of any of PCL's kinds, out of a point's bytes.
class FieldReader {
 public:
  FieldReader(const pcl::PCLPointCloud2& cloud, std::initializer_list<const char*> names) {
    for (const char* name : names)
      for (const pcl::PCLPointField& field : cloud.fields)
        if (!is_known_ && field.name == name && field.offset + 1U <= cloud.point_step) take(field, cloud.point_step);
  }
  bool is_known() const { return is_known_; }
  double at(const char* point) const {
    switch (type_) {
      case pcl::PCLPointField::INT8: return number_at<std::int8_t>(point, offset_);
      case pcl::PCLPointField::UINT8: return number_at<std::uint8_t>(point, offset_);
      case pcl::PCLPointField::INT16: return number_at<std::int16_t>(point, offset_);
      case pcl::PCLPointField::UINT16: return number_at<std::uint16_t>(point, offset_);
      case pcl::PCLPointField::INT32: return number_at<std::int32_t>(point, offset_);
      case pcl::PCLPointField::UINT32: return number_at<std::uint32_t>(point, offset_);
      case pcl::PCLPointField::FLOAT64: return number_at<double>(point, offset_);
      default: return number_at<float>(point, offset_);
    }
  }
  std::uint32_t word_at(const char* point) const { return number_at<std::uint32_t>(point, offset_); }

 private:
  void take(const pcl::PCLPointField& field, std::uint32_t point_step) {
    type_ = field.datatype;
    offset_ = field.offset;
    is_known_ = field.offset + static_cast<std::uint32_t>(pcl::getFieldSize(field.datatype)) <= point_step;
  }
  bool is_known_ = false;
  std::uint8_t type_ = 0;
  std::size_t offset_ = 0;
};

/// Of a packed body: what its own head promises.
std::uint64_t packed_bytes(const std::string& path, std::uint64_t data_at) {
  std::ifstream in(path, std::ios::binary);
  char head[8] = {};
  in.seekg(static_cast<std::streamoff>(data_at));
  in.read(head, sizeof head);
  return sizeof head + number_at<std::uint32_t>(head, 0);
}

/// What stops a file from being read, before PCL makes room for it.
std::optional<Issue> problem_of_pcd(const std::string& path, std::uint64_t file_bytes) {
  pcl::PCLPointCloud2 head;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0, kind = 0;
  unsigned int data_at = 0;
  if (pcl::PCDReader().readHeader(path, head, origin, orientation, version, kind, data_at) != 0) return error_in(path, "no PCD file that can be read", "save it as PCD 0.7, PLY or LAS");
  for (const char* name : {"x", "y", "z"})
    if (!FieldReader(head, {name}).is_known()) return error_in(path, std::string("its points have no ") + name, "save it as PCD 0.7 with x, y and z, as PLY or as LAS");
  const std::uint64_t points = static_cast<std::uint64_t>(head.width) * head.height, bytes = points * head.point_step;
  if (points > most_whole_cloud_bytes || bytes > most_whole_cloud_bytes) return too_large(path);
  constexpr int text = 0, binary = 1;
  const std::uint64_t least = kind == text ? points * head.fields.size() : kind == binary ? bytes : packed_bytes(path, data_at);
  if (data_at + least > file_bytes) return cut_off(path, points);
  return std::nullopt;
}

std::optional<Issue> problem_of_ply(const std::string& path, std::uint64_t file_bytes) {
  std::ifstream in(path, std::ios::binary);
  const auto head = read_ply_header(in);
  if (!head) return error_in(path, "no PLY file with points that can be read", "save it as PLY with vertices x, y and z, as PCD or as LAS");
  if (head->vertices > most_whole_cloud_bytes || head->vertices * std::max<std::uint64_t>(head->bytes_per_vertex, 12) > most_whole_cloud_bytes) return too_large(path);
  const std::uint64_t least = head->vertices * (head->is_text ? 2 * head->properties : head->bytes_per_vertex);
  if (head->header_bytes + least > file_bytes + 1) return cut_off(path, head->vertices);
  return std::nullopt;
}

/// False where a coordinate is missing.
bool collect(const pcl::PCLPointCloud2& cloud, CloudCollector& collector, const Progress& progress) {
  const FieldReader x(cloud, {"x"}), y(cloud, {"y"}), z(cloud, {"z"});
  const FieldReader colour(cloud, {"rgb", "rgba"}), intensity(cloud, {"intensity", "scalar_intensity", "scalar_Intensity", "reflectance", "reflectivity"});
  if (!x.is_known() || !y.is_known() || !z.is_known() || cloud.point_step == 0) return false;
  const std::size_t count = cloud.data.size() / cloud.point_step;
  // Some intensities run from 0 to 1, some to 65535: only their order matters.
  double most = 0.0;
  const auto point_at = [&cloud](std::size_t i) { return reinterpret_cast<const char*>(cloud.data.data()) + i * cloud.point_step; };
  if (intensity.is_known())
    for (std::size_t i = 0; i < count; ++i)
      if (const double value = intensity.at(point_at(i)); std::isfinite(value)) most = std::max(most, value);
  const double factor = most > 0.0 ? 65535.0 / most : 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % points_per_check == 0) progress.at(static_cast<double>(i) / static_cast<double>(count), "Thinning points");
    const char* bytes = point_at(i);
    RawPoint point;
    point.position = {x.at(bytes), y.at(bytes), z.at(bytes)};
    if (!point.position.allFinite()) continue;
    if (intensity.is_known()) point.intensity = static_cast<std::uint16_t>(std::clamp(intensity.at(bytes) * factor, 0.0, 65535.0));
    if (colour.is_known()) {
      const std::uint32_t word = colour.word_at(bytes);
      point.red = static_cast<std::uint8_t>(word >> 16);
      point.green = static_cast<std::uint8_t>(word >> 8);
      point.blue = static_cast<std::uint8_t>(word);
    }
    collector.add(point);
  }
  return true;
}

}  // namespace

Result<CloudUnderlay> read_pcl_points(const UnderlayRequest& request, const Progress& progress) {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // PCL speaks on the console; people are told here
  const std::string& path = request.path;
  std::error_code code;
  const std::uint64_t file_bytes = fs::file_size(path, code);
  if (code) return Result<CloudUnderlay>::failure(error_in(path, "the file cannot be opened", "is it there, and may you read it?"));
  const bool is_ply = lower_suffix(path) == ".ply";
  const auto placement = FilePlacement::of("", request);
  if (!placement) return Result<CloudUnderlay>::failure(placement.issues);
  try {
    if (const auto problem = is_ply ? problem_of_ply(path, file_bytes) : problem_of_pcd(path, file_bytes)) return Result<CloudUnderlay>::failure(*problem);
    progress.at(0.0, "Reading points");
    pcl::PCLPointCloud2 cloud;
    const int outcome = is_ply ? pcl::PLYReader().read(path, cloud) : pcl::PCDReader().read(path, cloud);
    progress.at(0.4, "Thinning points");
    CloudCollector collector(*placement);
    if (outcome < 0 || !collect(cloud, collector, progress.stage(0.4, 0.8)))
      return Result<CloudUnderlay>::failure(error_in(path, "its points cannot be read", "the file may be damaged or cut off; else save it as LAS"));
    cloud = {};
    return collector.finish(request, progress.stage(0.8, 1.0));
  } catch (const std::exception& error) {
    return Result<CloudUnderlay>::failure(error_in(path, std::string("its points cannot be read: ") + error.what(), "the file may be damaged or cut off"));
  }
}

}  // namespace stemwise
