#pragma once
#include <string>
#include <vector>

#include "ui/view_state.hpp"

namespace stemwise {

/// What the window remembers from one day to the next.
struct Preferences {
  int width = 1440;
  int height = 900;
  bool maximised = false;
  ui::ThemeName theme = ui::ThemeName::light;
  bool reduce_motion = false;
  bool goes_on = false;
  double zoom_percent = 100.0;
  ui::PanelSizes panels;
  ui::Layers layers;
  std::vector<std::string> recent_projects;  ///< newest first
  std::string working_folder;

  bool operator==(const Preferences&) const = default;
  void remember_project(const std::string& path);
  void forget_project(const std::string& path);
};

/// Defaults where the file is missing or broken: preferences never stop anybody.
Preferences read_preferences(const std::string& path);
/// Beside it and renamed; false when it could not be written.
bool write_preferences(const std::string& path, const Preferences& preferences);

}  // namespace stemwise
