#include "io/read_frame_folder.hpp"

#include <algorithm>
#include <filesystem>

#include "io/frame_folder.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

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

Inventory inventory_from(const std::string& folder, const std::string& name, FrameSet set) {
  Inventory inventory;
  inventory.name = name;
  inventory.date = date_of(set);
  std::size_t stems = 0, measured = 0, with_axis = 0;
  for (const Frame& frame : set.frames) {
    stems += frame.stems.size();
    for (const Stem& stem : frame.stems) {
      measured += stem.dbh_m.has_value() ? 1 : 0;
      with_axis += stem.axis.has_value() ? 1 : 0;
    }
  }
  inventory.source.path = fs::absolute(fs::path(folder).lexically_normal()).string();  // a project finds the frames again wherever it is opened from
  inventory.source.format = "frame folder";
  inventory.source.notes = {std::to_string(set.frames.size()) + " frames, " + std::to_string(stems) + " stems seen",
                            "positions: m, in each frame", "dbh: m, measured for " + std::to_string(measured) + " of them",
                            "axis: for " + std::to_string(with_axis) + " of them",
                            inventory.date ? "date: median time stamp of the trajectory" : "date: the time stamps are none"};
  if (!inventory.date) inventory.date = parse_date(inventory.name);
  inventory.frames = std::make_shared<const FrameSet>(std::move(set));
  return inventory;
}

}  // namespace

Result<Inventory> read_frame_folder(const std::string& folder, int threads) {
  auto opened = FrameFolder::open(folder);
  if (!opened) return Result<Inventory>::failure(std::move(opened.issues));
  auto frames = opened->read(0, opened->size(), threads);
  Issues issues = std::move(opened.issues);
  issues.insert(issues.end(), std::make_move_iterator(frames.issues.begin()), std::make_move_iterator(frames.issues.end()));
  if (std::all_of(frames->begin(), frames->end(), [](const Frame& f) { return f.stems.empty(); })) {
    issues.push_back(opened->nothing_usable());
    return Result<Inventory>::failure(std::move(issues));
  }
  return {inventory_from(folder, opened->name(), {std::move(*frames)}), std::move(issues)};
}

}  // namespace stemwise
