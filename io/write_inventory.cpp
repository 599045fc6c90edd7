#include "io/write_inventory.hpp"

#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "io/write_whole_file.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

Result<Done> refused(const std::string& path, const std::string& text, const std::string& help) {
  return Result<Done>::failure(Issue{Severity::error, path, 0, "", text, help});
}

std::string optional_number(const std::optional<double>& value) { return value ? exact_number(*value) : ""; }

std::string quoted(const std::string& cell, char delimiter) {
  if (cell.find_first_of(std::string("\"\r\n") + delimiter) == std::string::npos) return cell;
  std::string out = "\"";
  for (const char c : cell) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

const char* status_word(StemStatus status) {
  return status == StemStatus::unknown ? "" : to_string(status);
}

/// To 1e-10 cm, so that metres to centimetres and back does not count up last digits.
double rounded_cm(double dbh_m) { return std::round(dbh_m * 1e12) / 1e10; }

std::string stem_line(const Stem& stem, const std::optional<Date>& survey_date, char delimiter) {
  const std::optional<Date> date = stem.date ? stem.date : survey_date;
  const std::array<std::string, 11> cells{quoted(stem.source_id, delimiter),
                                          exact_number(stem.x_m),
                                          exact_number(stem.y_m),
                                          optional_number(stem.z_m),
                                          stem.dbh_m ? exact_number(rounded_cm(*stem.dbh_m)) : "",
                                          stem.axis ? exact_number(stem.axis->x()) : "",
                                          stem.axis ? exact_number(stem.axis->y()) : "",
                                          stem.axis ? exact_number(stem.axis->z()) : "",
                                          quoted(stem.species, delimiter),
                                          status_word(stem.status),
                                          date ? to_string(*date) : ""};
  std::string line;
  for (const std::string& cell : cells) line += (&cell == cells.data() ? "" : std::string(1, delimiter)) + cell;
  return line + "\n";
}

/// A rotation whose third column is the axis: what is around the axis is not known, so the turn is the smallest one.
Eigen::Matrix3d rotation_with_axis(const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
}

std::string frame_table(const Frame& frame) {
  std::string text =
      "axis_00,axis_01,axis_02,axis_10,axis_11,axis_12,axis_20,axis_21,axis_22,location_x,location_y,location_z,"
      "dbh,dbh_approximation,score,reconstructed,number_clusters\n";
  for (const Stem& stem : frame.stems) {
    const Eigen::Matrix3d rotation = rotation_with_axis(stem.axis.value_or(Eigen::Vector3d::UnitZ()));
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) text += stem.axis ? exact_number(c == 2 ? (*stem.axis)[r] : rotation(r, c)) + "," : ",";
    }
    text += exact_number(stem.x_m) + "," + exact_number(stem.y_m) + "," + optional_number(stem.z_m) + "," + optional_number(stem.dbh_m) + "," +
            optional_number(stem.dbh_approximation_m) + "," + exact_number(stem.score) + "," + (stem.reconstructed ? "1" : "0") + "," +
            std::to_string(stem.number_clusters) + "\n";
  }
  return text;
}

std::string trajectory_text(const FrameSet& frames) {
  std::string text = "# timestamp x y z qx qy qz qw\n";
  for (const Frame& frame : frames.frames) {
    const Eigen::Vector3d& t = frame.pose.survey_from_frame.translation_m;
    const Eigen::Quaterniond q(frame.pose.survey_from_frame.rotation);
    for (const double value : {frame.pose.timestamp_s, t.x(), t.y(), t.z(), q.x(), q.y(), q.z()}) text += exact_number(value) + " ";
    text += exact_number(q.w()) + "\n";
  }
  return text;
}

Result<Done> fill_folder(const fs::path& folder, const FrameSet& frames) {
  if (Result<Done> done = write_whole_file((folder / "trajectory.txt").string(), trajectory_text(frames)); !done) return done;
  for (std::size_t n = 0; n < frames.frames.size(); ++n) {
    const fs::path file = folder / ("TreeManagerState_" + std::to_string(n) + ".csv");
    if (Result<Done> done = write_whole_file(file.string(), frame_table(frames.frames[n])); !done) return done;
  }
  return Done{};
}

bool may_be_replaced(const fs::path& folder) {
  std::error_code code;
  if (!fs::exists(folder, code) || fs::is_empty(folder, code)) return true;
  return fs::exists(folder / "trajectory.txt", code);
}

}  // namespace

std::string exact_number(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == 0.0 ? 0.0 : value).ptr};
}

std::string stem_table(const Inventory& inventory, char delimiter) {
  std::string text;
  for (const char* name : {"id", "x_m", "y_m", "z_m", "dbh_cm", "axis_x", "axis_y", "axis_z", "species", "status", "date"}) {
    text += (text.empty() ? "" : std::string(1, delimiter)) + name;
  }
  text += "\n";
  for (const Stem& stem : inventory.stems) text += stem_line(stem, inventory.date, delimiter);
  return text;
}

Result<Done> write_frame_folder(const std::string& folder, const FrameSet& frames) {
  const fs::path place = fs::path(folder).lexically_normal();
  if (!may_be_replaced(place)) return refused(folder, "is there already and is no frame folder", "name another folder");
  const fs::path beside = place.string() + ".part" + std::to_string(getpid());
  std::error_code code;
  fs::create_directories(beside, code);
  Result<Done> done = code ? refused(folder, "cannot be written", "may you write there?") : fill_folder(beside, frames);
  if (done) {
    fs::remove_all(place, code);
    fs::rename(beside, place, code);
    if (code) done = refused(folder, "cannot be written", "may you write there?");
  }
  if (!done) fs::remove_all(beside, code);
  return done;
}

const std::vector<std::string>& inventory_suffixes() {
  static const std::vector<std::string> suffixes = {".csv", ".tsv", ".txt", ""};
  return suffixes;
}

Result<Done> write_inventory(const std::string& path, const Inventory& inventory) {
  std::string suffix = fs::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".csv" || suffix == ".txt") return write_whole_file(path, stem_table(inventory));
  if (suffix == ".tsv") return write_whole_file(path, stem_table(inventory, '\t'));
  if (!suffix.empty()) return refused(path, "'" + suffix + "' is no format that inventories are written in", "use .csv or .tsv, or a folder's name for frames");
  if (inventory.frames) return write_frame_folder(path, *inventory.frames);
  return refused(path, "a frame folder needs frames, and this inventory has none", "use .csv");
}

}  // namespace stemwise
