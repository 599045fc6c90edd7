#pragma once
#include "ui/dialogs/import_settings_panel.hpp"
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Files as they will be understood, before they are taken into the project: files left, settings in the middle, first rows
/// and problems right.
class ImportDialog {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_files(Widgets& w, const std::vector<ImportFile>& files, float width, float height);
  void draw_file(Widgets& w, const ImportFile& file, std::size_t index);
  void draw_result(Widgets& w, const ImportFile& file, float height);
  void draw_rows(Widgets& w, const ImportFile& file, float height);
  void draw_problems(Widgets& w, const ImportFile& file, float height);
  void draw_foot(Widgets& w, Frame& frame, const std::vector<ImportFile>& files);

  ImportSettingsPanel settings_;
  std::size_t shown_ = 0;
  bool as_in_file_ = false;
};

}  // namespace stemwise::ui
