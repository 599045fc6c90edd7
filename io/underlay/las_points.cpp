#include "io/underlay/las_points.hpp"

#include <algorithm>
#include <fstream>

#include "io/underlay/las_header.hpp"
#include "io/underlay/little_endian.hpp"

namespace stemwise {
namespace {

constexpr std::uint64_t bytes_per_read = 1 << 20;
constexpr unsigned ground_class = 2, low_noise_class = 7, high_noise_class = 18;

Issue issue_in(const std::string& path, std::string text, std::string help, Severity severity = Severity::error) {
  return {severity, path, 0, {}, std::move(text), std::move(help)};
}

/// How one record becomes a point.
class RecordReader {
 public:
  explicit RecordReader(const LasHeader& header) : header_(header), is_new_(header.point_format >= 6), colour_at_(las_colour_at(header.point_format)) {}

  unsigned class_of(const char* record) const {
    return is_new_ ? static_cast<unsigned char>(record[16]) : static_cast<unsigned char>(record[15]) & 0x1FU;
  }
  bool is_wanted(const char* record) const {
    const bool is_withheld = is_new_ ? (record[15] & 0x04) != 0 : (record[15] & 0x80) != 0;
    const unsigned kind = class_of(record);
    return !is_withheld && kind != low_noise_class && !(is_new_ && kind == high_noise_class);
  }
  RawPoint point_of(const char* record) {
    RawPoint point;
    for (std::size_t axis = 0; axis < 3; ++axis)
      point.position[static_cast<Eigen::Index>(axis)] = number_at<std::int32_t>(record, 4 * axis) * header_.scale[axis] + header_.offset[axis];
    point.intensity = number_at<std::uint16_t>(record, 12);
    point.is_ground = class_of(record) == ground_class;
    if (colour_at_ == 0) return point;
    const auto r = number_at<std::uint16_t>(record, colour_at_), g = number_at<std::uint16_t>(record, colour_at_ + 2), b = number_at<std::uint16_t>(record, colour_at_ + 4);
    is_wide_ |= (r | g | b) > 255;  // the standard has 16 bits; many programs write 8 into them
    const int shift = is_wide_ ? 8 : 0;
    point.red = static_cast<std::uint8_t>(r >> shift);
    point.green = static_cast<std::uint8_t>(g >> shift);
    point.blue = static_cast<std::uint8_t>(b >> shift);
    return point;
  }

 private:
  const LasHeader& header_;
  bool is_new_;
  std::uint32_t colour_at_;
  bool is_wide_ = false;
};

/// The number of records that were there.
std::uint64_t read_records(std::istream& in, const LasHeader& header, CloudCollector& collector, const Progress& progress) {
  RecordReader reader(header);
  const std::uint64_t records_per_read = bytes_per_read / header.record_bytes;  // a record has at most 65,535 bytes
  std::vector<char> bytes(records_per_read * header.record_bytes);
  in.seekg(static_cast<std::streamoff>(header.first_point_at));
  std::uint64_t done = 0;
  while (done < header.point_count) {
    progress.at(static_cast<double>(done) / static_cast<double>(header.point_count), "Reading points");
    const std::uint64_t wanted = std::min(records_per_read, header.point_count - done);
    in.read(bytes.data(), static_cast<std::streamsize>(wanted * header.record_bytes));
    const std::uint64_t got = static_cast<std::uint64_t>(in.gcount()) / header.record_bytes;
    for (std::uint64_t i = 0; i < got; ++i) {
      const char* record = bytes.data() + i * header.record_bytes;
      if (reader.is_wanted(record)) collector.add(reader.point_of(record));
    }
    done += got;
    if (got < wanted) break;
  }
  return done;
}

}  // namespace

Result<CloudUnderlay> read_las_points(const UnderlayRequest& request, const Progress& progress) {
  std::ifstream in(request.path, std::ios::binary);
  if (!in) return Result<CloudUnderlay>::failure(issue_in(request.path, "the file cannot be opened", "is it there, and may you read it?"));
  const Result<LasHeader> header = read_las_header(in, request.path);
  if (!header) return Result<CloudUnderlay>::failure(header.issues);
  if (header->is_compressed)
    return Result<CloudUnderlay>::failure(issue_in(request.path, "it is a compressed point cloud (LAZ), which cannot be read here",
                                                   "unpack it to LAS first: laszip -i FILE.laz -o FILE.las, or pdal translate FILE.laz FILE.las, or save it as LAS from CloudCompare or QGIS"));
  const auto placement = FilePlacement::of(header->wkt, request);
  if (!placement) return Result<CloudUnderlay>::failure(placement.issues);
  CloudCollector collector(*placement);
  in.clear();
  const std::uint64_t got = read_records(in, *header, collector, progress.stage(0.0, 0.7));
  Result<CloudUnderlay> result = collector.finish(request, progress.stage(0.7, 1.0));
  if (got < header->point_count)
    result.issues.push_back(issue_in(request.path, "it ends after " + std::to_string(got) + " of " + std::to_string(header->point_count) + " points",
                                     "the file may be cut off: copy it again", Severity::warning));
  return result;
}

}  // namespace stemwise
