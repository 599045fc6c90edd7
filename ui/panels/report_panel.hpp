#pragma once
#include "ui/frame.hpp"
#include "ui/panels/export_form_panel.hpp"
#include "ui/panels/rules_form.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Step 5, right: exports, the growth report with what will be in it, rules for growth, the sheet to take outside.
class ReportPanel {
 public:
  void draw(Widgets& w, Frame& frame);
  void set_export_path(const std::string& path) { export_.set_path(path); }
  void set_report_path(const std::string& path) { report_path_ = path; }
  void set_field_check_path(const std::string& path) { check_path_ = path; }

 private:
  bool is_section_open(Widgets& w, Frame& frame, ReportSection section, const char* path, const char* label, bool& open);
  void draw_report(Widgets& w, Frame& frame);
  void draw_contents(Widgets& w, const Frame& frame);
  void draw_field_check(Widgets& w, Frame& frame);
  void start_paths(const Frame& frame);

  ExportFormPanel export_;
  RulesForm rules_;
  int frames_wanted_ = 0;  ///< that a section which was asked for has been drawn
  bool export_open_ = true, report_open_ = true, contents_open_ = false, rules_open_ = false, check_open_ = false;
  std::string report_path_, check_path_;
  std::string proposed_report_, proposed_check_;  ///< for the open project; in the fields until a person writes something else
};

}  // namespace stemwise::ui
