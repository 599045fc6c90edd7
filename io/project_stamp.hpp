#pragma once
#include <string>

namespace stemwise {

/// What a project file holds, so that a change by another window or program is seen: the fingerprint of the tables of ours that is
/// written into it. What other programs keep beside them in the file does not count. Of a file without one: size, time and place.
struct ProjectStamp {
  std::string text;  ///< empty: there is no file
  bool operator==(const ProjectStamp&) const = default;
};

ProjectStamp project_stamp(const std::string& path);

/// The file holds something now that was not there when `known` was taken: replacing it would lose that.
bool is_changed_since(const ProjectStamp& known, const std::string& path);

}  // namespace stemwise
