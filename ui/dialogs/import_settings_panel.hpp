#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// How one file is read: name, date, coordinates, columns, units, status codes; every change asks for reading it again.
class ImportSettingsPanel {
 public:
  void draw(Widgets& w, Frame& frame, const ImportFile& file, std::size_t index);

 private:
  void fill_fields(const ImportFile& file);
  void draw_general(Widgets& w, const ImportFile& file);
  void draw_date(Widgets& w, const ImportFile& file);
  void draw_system(Widgets& w, const ImportFile& file);
  void draw_part(Widgets& w, const ImportFile& file);
  void draw_columns(Widgets& w, const ImportFile& file);
  void draw_scheme(Widgets& w, const ImportFile& file);
  void draw_column(Widgets& w, const ImportFile& file, const char* kind, const char* label, bool needed);
  void draw_unit(Widgets& w, const ImportFile& file, const std::string& kind, float width);
  void draw_codes(Widgets& w, const ImportFile& file);

  // What the fields below are of.
  std::string path_;
  ImportSettings read_;
  std::optional<Date> date_read_;
  std::optional<int> epsg_read_;
  std::string name_, date_, epsg_;
  std::optional<int> scheme_;    ///< chosen here, until its columns are
  ImportSettings wanted_;
};

}  // namespace stemwise::ui
