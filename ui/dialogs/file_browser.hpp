#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

struct FileBrowserMode {
  std::string title;
  std::string accept;                 ///< label of the button that ends it
  std::vector<std::string> suffixes;  ///< ".gpkg"; empty: every file
  bool save = false;                  ///< asks for a name
  bool many = false;                  ///< several files, and frame folders
  std::string name;                   ///< proposed, for saving
};

/// A file dialog in the window itself: the same on every desktop.
class FileBrowser {
 public:
  /// The field for the path has the keyboard, when a file is to be named the one for its name. `places`: folders to go to by a click.
  void open(FileBrowserMode mode, const std::string& folder, const std::string& home, const std::vector<std::string>& places);
  bool is_open() const { return open_; }
  /// Draws it while open. The paths when the person accepts.
  std::optional<std::vector<std::string>> draw(Widgets& w);

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    bool frames = false;  ///< a folder that is an inventory
    std::uintmax_t bytes = 0;
  };
  struct Place {
    std::string path, label;
    const char* icon;
  };
  void list(const std::string& folder);
  void draw_path(Widgets& w);
  void find_places(const std::string& home, const std::vector<std::string>& places);
  void draw_places(Widgets& w, float height);
  void draw_entries(Widgets& w, float height);
  void draw_entry(Widgets& w, const Entry& entry, std::size_t row);
  void choose(const Entry& entry, bool add);
  std::optional<std::vector<std::string>> draw_buttons(Widgets& w);
  std::string why_not() const;
  std::string file_name() const;
  std::vector<std::string> chosen() const;
  void go_to_typed_path();

  FileBrowserMode mode_;
  bool open_ = false;
  bool is_new_ = false;    ///< not drawn yet
  bool accepted_ = false;  ///< by a double click
  std::string folder_;
  std::string typed_;
  std::string name_;
  std::string problem_;
  std::vector<Place> places_;
  std::vector<Entry> entries_;
  std::set<std::string> selected_;
};

}  // namespace stemwise::ui
