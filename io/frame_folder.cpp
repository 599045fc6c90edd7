#include "io/frame_folder.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <tuple>

#include "core/base/parallel.hpp"
#include "io/read_frame_file.hpp"
#include "io/read_frame_folder.hpp"
#include "io/read_trajectory.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
using Poses = std::vector<std::optional<TrajectoryPose>>;

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
std::vector<FrameFile> files_with_pose(std::vector<FrameFile> files, const Poses& poses, Issues& issues) {
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

std::string last_part(const std::string& folder) {
  const fs::path path = fs::path(folder).lexically_normal();
  return path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
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

Result<FrameFolder> FrameFolder::open(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return Result<FrameFolder>::failure(
        {Severity::error, folder, 0, "", "there is no such folder", "expected trajectory.txt and TreeManagerState_<n>.csv"});
  }
  auto files = list_frame_files(folder);
  auto trajectory = read_trajectory((fs::path(folder) / "trajectory.txt").string());
  if (!trajectory) return Result<FrameFolder>::failure(std::move(trajectory.issues));
  Issues issues = std::move(trajectory.issues);
  if (files.empty()) {
    issues.push_back({Severity::error, folder, 0, "", "the folder has no TreeManagerState_<n>.csv", ""});
    return Result<FrameFolder>::failure(std::move(issues));
  }
  name_poses_without_file(folder, files, trajectory->size(), issues);
  FrameFolder opened;
  opened.folder_ = folder;
  opened.name_ = last_part(folder);
  for (FrameFile& file : files_with_pose(std::move(files), *trajectory, issues))
    opened.files_.push_back({file.number, std::move(file.path), *(*trajectory)[static_cast<std::size_t>(file.number)]});
  return {std::move(opened), std::move(issues)};
}

Result<std::vector<Frame>> FrameFolder::read(std::size_t first, std::size_t count, int threads) const {
  first = std::min(first, files_.size());
  count = std::min(count, files_.size() - first);
  std::vector<Result<std::vector<Stem>>> read(count);
  parallel_for(count, threads, [&](std::size_t i) { read[i] = read_frame_file(files_[first + i].path); });
  Issues issues;
  std::vector<Frame> frames;
  frames.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (Issue& issue : read[i].issues) {
      if (!read[i]) {
        issue.severity = Severity::warning;
        issue.text += ": the frame is left out";
      }
      issues.push_back(std::move(issue));
    }
    const File& file = files_[first + i];
    if (read[i]) frames.push_back({file.number, file.pose, std::move(*read[i])});
  }
  return {std::move(frames), std::move(issues)};
}

Issue FrameFolder::nothing_usable() const { return {Severity::error, folder_, 0, "", "no frame has a usable row", ""}; }

}  // namespace stemwise
