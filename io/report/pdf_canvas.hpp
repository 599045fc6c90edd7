#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/report/drawing.hpp"

namespace stemwise {

struct TextStyle {
  double size_pt = 9.0;
  std::string color;
  bool bold = false;
};

class RecordedPages;

/// Pages of A4, in points, y downwards from the top of the page. Text by pango, lines and fills by cairo. What is drawn becomes a
/// PDF, or is kept page by page to be looked at; both lie the same.
class PdfCanvas {
 public:
  static constexpr double page_width = 595.28, page_height = 841.89;

  PdfCanvas(const std::string& title, const std::string& software);
  PdfCanvas();  ///< keeps the pages, writes no PDF
  ~PdfCanvas();
  PdfCanvas(const PdfCanvas&) = delete;
  PdfCanvas& operator=(const PdfCanvas&) = delete;

  void end_page();
  /// The whole PDF; nothing when anything went wrong on the way. In memory, since cairo aborts the process on a full disk.
  std::optional<std::string> finish();
  /// The pages that were kept; none from a canvas that writes a PDF.
  RecordedPages take_pages();

  double text_width(const std::string& text, const TextStyle& style);
  /// Width of its longest word.
  double word_width(const std::string& text, const TextStyle& style);
  double text_height(const std::string& text, const TextStyle& style, double width);
  /// In a box whose upper left corner is given; wrapped at `width`. Returns its height.
  double text(double x, double y, double width, const std::string& text, const TextStyle& style, TextAnchor anchor = TextAnchor::start);
  void rule(double x, double y, double width, const std::string& color, double thickness = 0.6);
  void fill(double x, double y, double width, double height, const std::string& color, double radius = 0.0);
  void draw(const Drawing& drawing, double x, double y, double scale);
  /// An entry of the outline that a viewer shows beside the pages of a PDF.
  void bookmark(const std::string& title, int page);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace stemwise
