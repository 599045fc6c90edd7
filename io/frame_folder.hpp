#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/forest/frame_set.hpp"

namespace stemwise {

/// A frame folder (data-formats.md) whose frames are read some at a time: a survey's frames take hundreds of megabytes, what is
/// made of them one tenth. `read_frame_folder` reads all.
class FrameFolder {
 public:
  /// Reads the trajectory and lists the frames that have a pose; names poses without a frame and frames without a pose. A
  /// failure where there is no trajectory or no frame.
  static Result<FrameFolder> open(const std::string& folder);

  /// The last part of the path: what an inventory of it is called.
  const std::string& name() const { return name_; }
  /// Frames that have a pose, whether they can be read or not.
  std::size_t size() const { return files_.size(); }
  /// The frames from `first` on, at most `count`, in order of their numbers. Every bad row is an issue and is left out, and
  /// so is every frame that cannot be read. `threads` 0: all of the machine; the result does not depend on it.
  Result<std::vector<Frame>> read(std::size_t first, std::size_t count, int threads) const;
  /// What there is to say when no frame had a stem.
  Issue nothing_usable() const;

 private:
  struct File {
    std::int64_t number = 0;
    std::string path;
    TrajectoryPose pose;
  };
  std::string folder_, name_;
  std::vector<File> files_;
};

}  // namespace stemwise
