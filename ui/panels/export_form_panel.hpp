#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// What to write, in which format and coordinates, and where; with its first row as it would be written.
class ExportFormPanel {
 public:
  void draw(Widgets& w, Frame& frame);
  void set_path(const std::string& path) {
    path_ = path;
    follow_suffix();
  }
  /// A path beside the project's file, while the person has written no other.
  void propose_path(const std::string& folder, const std::string& title);

 private:
  void draw_format(Widgets& w, Frame& frame);
  void draw_crs(Widgets& w, Frame& frame);
  void draw_preview(Widgets& w, Frame& frame);
  std::string why_not(const Frame& frame) const;
  void follow_suffix();
  std::string suffix() const;

  int format_ = 0;
  int layer_ = 0;
  int crs_ = 0;
  double epsg_ = 25832;
  bool decimal_comma_ = false;
  bool semicolon_ = false;
  bool preview_open_ = false;
  std::string path_, proposed_;
};

}  // namespace stemwise::ui
