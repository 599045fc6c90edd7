#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Step 5, right: what to write, in which format and CRS, and where.
class ReportPanel {
 public:
  void draw(Widgets& w, Frame& frame);
  void set_export_path(const std::string& path) {
    export_path_ = path;
    follow_suffix();
  }
  void set_report_path(const std::string& path) { report_path_ = path; }

 private:
  void draw_export(Widgets& w, Frame& frame);
  void draw_format(Widgets& w);
  void draw_crs(Widgets& w, const Frame& frame);
  void draw_report(Widgets& w, Frame& frame);
  void follow_suffix();
  std::string suffix() const;
  void start_paths(const Frame& frame);

  int format_ = 0;
  int layer_ = 0;
  int crs_ = 0;
  double epsg_ = 25832;
  bool decimal_comma_ = false;
  bool semicolon_ = false;
  std::string export_path_, report_path_;
  std::string proposed_export_, proposed_report_;  ///< for the open project; in the fields until a person writes something else
  double area_ha_ = 0.0;
};

}  // namespace stemwise::ui
