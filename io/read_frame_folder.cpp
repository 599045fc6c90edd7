#include "io/read_frame_folder.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>

#include "core/base/parallel.hpp"
#include "io/read_frame_file.hpp"
#include "io/read_trajectory.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

struct FrameFile {
  std::int64_t number = 0;
  std::string path;
};

/// n of "TreeManagerState_<n>.csv".
std::optional<std::int64_t> frame_number(std::string_view file_name) {
  constexpr std::string_view before = "TreeManagerState_";
  constexpr std::string_view after = ".csv";
  if (file_name.size() <= before.size() + after.size() || !file_name.starts_with(before) || !file_name.ends_with(after))
    return std::nullopt;
  file_name.remove_prefix(before.size());
  file_name.remove_suffix(after.size());
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(file_name.data(), file_name.data() + file_name.size(), number);
  if (error != std::errc{} || end != file_name.data() + file_name.size() || number < 0) return std::nullopt;
  return number;
}

std::vector<FrameFile> list_frame_files(const std::string& folder) {
  std::vector<FrameFile> files;
  std::error_code error;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (const auto number = frame_number(name)) files.push_back({*number, entry->path().string()});
  }
  std::sort(files.begin(), files.end(),
            [](const FrameFile& a, const FrameFile& b) { return std::tie(a.number, a.path) < std::tie(b.number, b.path); });
  return files;
}

Issue warn(const std::string& file, std::string text) { return {Severity::warning, file, 0, "", std::move(text), ""}; }

/// Files that have a pose, in order; the others are named.
std::vector<FrameFile> files_with_pose(std::vector<FrameFile> files, const std::vector<std::optional<TrajectoryPose>>& poses,
                                       Issues& issues) {
  std::vector<FrameFile> kept;
  for (FrameFile& file : files) {
    const auto row = static_cast<std::size_t>(file.number);
    if (row >= poses.size()) {
      issues.push_back(warn(file.path, "the trajectory has " + std::to_string(poses.size()) + " poses and none for frame " +
                                           std::to_string(file.number) + ": the frame is left out"));
    } else if (!poses[row]) {
      issues.push_back(
          warn(file.path, "the trajectory's line for frame " + std::to_string(file.number) + " is bad: the frame is left out"));
    } else if (!kept.empty() && kept.back().number == file.number) {
      issues.push_back(warn(file.path, "a second file for frame " + std::to_string(file.number) + " is left out"));
    } else {
      kept.push_back(std::move(file));
    }
  }
  return kept;
}

void name_poses_without_file(const std::string& folder, const std::vector<FrameFile>& files, std::size_t pose_count,
                             Issues& issues) {
  std::vector<char> has_file(pose_count, 0);
  for (const FrameFile& file : files) {
    if (static_cast<std::size_t>(file.number) < pose_count) has_file[static_cast<std::size_t>(file.number)] = 1;
  }
  std::string missing;
  std::size_t count = 0;
  for (std::size_t n = 0; n < pose_count; ++n) {
    if (has_file[n] != 0) continue;
    const std::size_t from = n;
    while (n + 1 < pose_count && has_file[n + 1] == 0) ++n;
    count += n - from + 1;
    missing += (missing.empty() ? "" : ", ") + std::to_string(from) + (n > from ? "-" + std::to_string(n) : "");
  }
  if (count > 0)
    issues.push_back(warn(folder, std::to_string(count) + " poses of the trajectory have no frame file: " + missing));
}

/// The median time stamp's day where all are plausible Unix times (data-formats.md): those of some data sets are not.
std::optional<Date> date_of(const FrameSet& set) {
  std::vector<double> times;
  for (const Frame& frame : set.frames) times.push_back(frame.pose.timestamp_s);
  constexpr double year_2000_s = 946684800.0;
  constexpr double year_2100_s = 4102444800.0;
  const auto plausible = [](double t) { return t > year_2000_s && t < year_2100_s; };
  if (times.empty() || !std::all_of(times.begin(), times.end(), plausible)) return std::nullopt;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return Date{static_cast<int>(*middle / 86400.0)};
}

Inventory inventory_from(const std::string& folder, FrameSet set) {
  const fs::path path = fs::path(folder).lexically_normal();
  Inventory inventory;
  inventory.name = path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
  inventory.date = date_of(set);
  std::size_t stems = 0, measured = 0, with_axis = 0;
  for (const Frame& frame : set.frames) {
    stems += frame.stems.size();
    for (const Stem& stem : frame.stems) {
      measured += stem.dbh_m.has_value() ? 1 : 0;
      with_axis += stem.axis.has_value() ? 1 : 0;
    }
  }
  inventory.source.path = fs::absolute(path).string();  // a project finds the frames again wherever it is opened from
  inventory.source.format = "frame folder";
  inventory.source.notes = {std::to_string(set.frames.size()) + " frames, " + std::to_string(stems) + " stems seen",
                            "positions: m, in each frame", "dbh: m, measured for " + std::to_string(measured) + " of them",
                            "axis: for " + std::to_string(with_axis) + " of them",
                            inventory.date ? "date: median time stamp of the trajectory" : "date: the time stamps are none"};
  if (!inventory.date) inventory.date = parse_date(inventory.name);
  inventory.frames = std::make_shared<const FrameSet>(std::move(set));
  return inventory;
}

/// Frames of the files, read in parallel; unreadable ones are left out and named.
FrameSet read_frames(const std::vector<FrameFile>& files, const std::vector<std::optional<TrajectoryPose>>& poses, int threads,
                     Issues& issues) {
  std::vector<Result<std::vector<Stem>>> read(files.size());
  parallel_for(files.size(), threads, [&](std::size_t i) { read[i] = read_frame_file(files[i].path); });
  FrameSet set;
  set.frames.reserve(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (Issue& issue : read[i].issues) {
      if (!read[i]) {
        issue.severity = Severity::warning;
        issue.text += ": the frame is left out";
      }
      issues.push_back(std::move(issue));
    }
    if (read[i]) set.frames.push_back({files[i].number, *poses[static_cast<std::size_t>(files[i].number)], std::move(*read[i])});
  }
  return set;
}

}  // namespace

bool is_frame_folder(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return false;
  if (fs::exists(fs::path(folder) / "trajectory.txt", error)) return true;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error)) {
    if (frame_number(entry->path().filename().string())) return true;
  }
  return false;
}

Result<Inventory> read_frame_folder(const std::string& folder, int threads) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return Result<Inventory>::failure(
        {Severity::error, folder, 0, "", "there is no such folder", "expected trajectory.txt and TreeManagerState_<n>.csv"});
  }
  auto files = list_frame_files(folder);
  auto trajectory = read_trajectory((fs::path(folder) / "trajectory.txt").string());
  if (!trajectory) return Result<Inventory>::failure(std::move(trajectory.issues));
  Issues issues = std::move(trajectory.issues);
  if (files.empty()) {
    issues.push_back({Severity::error, folder, 0, "", "the folder has no TreeManagerState_<n>.csv", ""});
    return Result<Inventory>::failure(std::move(issues));
  }
  name_poses_without_file(folder, files, trajectory->size(), issues);
  const auto kept = files_with_pose(std::move(files), *trajectory, issues);
  FrameSet set = read_frames(kept, *trajectory, threads, issues);
  if (std::all_of(set.frames.begin(), set.frames.end(), [](const Frame& f) { return f.stems.empty(); })) {
    issues.push_back({Severity::error, folder, 0, "", "no frame has a usable row", ""});
    return Result<Inventory>::failure(std::move(issues));
  }
  return {inventory_from(folder, std::move(set)), std::move(issues)};
}

}  // namespace stemwise
