#pragma once
#include <map>
#include <string>
#include <vector>

#include "ui/view_state.hpp"

namespace stemwise {

/// Which underlays a project had and how they were shown, by the project's file: a setting of this window on this machine,
/// not of the project, whose file may travel without the pictures.
class UnderlayMemory {
 public:
  /// Nothing where the file is missing or broken. An empty path: nothing is kept beyond this window.
  static UnderlayMemory read(const std::string& path);

  /// Ready to be read; without ids.
  std::vector<ui::Underlay> find(const std::string& project) const;
  /// Writes the file, beside it and renamed, when something changed.
  void remember(const std::string& project, const std::vector<ui::Underlay>& underlays);

 private:
  void write() const;

  std::string path_;
  std::map<std::string, std::string> entries_;  ///< JSON, by project
};

}  // namespace stemwise
